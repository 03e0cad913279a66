// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/frame_tree.h"

#include "backend/ros/stamps.h"

#include <algorithm>
#include <utility>

namespace teleta::ros_arm {

namespace {

constexpr double kShortestQuaternion = 1e-6;
constexpr double kLongestQuaternion = 1e6;

/// Older programs write a slash before the name.
std::string nameOf(const char* text) {
    std::string name = text == nullptr ? "" : text;
    if (name.starts_with('/'))
        name.erase(0, 1);
    return name;
}

} // namespace

void FrameTree::take(const ros::TFMessage& message, std::optional<std::int64_t> read_ns) {
    for (const auto& told : ros::view(message.transforms)) {
        const auto& [x, y, z] = told.transform.translation;
        const auto& turn = told.transform.rotation;
        const Eigen::Vector3d p_Parent_Frame(x, y, z);
        const Eigen::Quaterniond rotation(turn.w, turn.x, turn.y, turn.z);
        const std::string name = nameOf(told.child_frame_id);
        // Sums of such places, and squares of such rotations, do not overflow.
        const bool isUsable = (p_Parent_Frame.array().abs() <= kFarthest_m).all() &&
                              (rotation.coeffs().array().abs() <= kLongestQuaternion).all() &&
                              rotation.norm() > kShortestQuaternion && !name.empty();
        if (!isUsable || (m_frames.size() >= kMostFrames && !m_frames.contains(name)))
            continue;
        Hung hung{nameOf(told.header.frame_id), Eigen::Isometry3d::Identity(), read_ns,
                  ros::seconds(told.header.stamp)};
        hung.X_Parent_Frame.translation() = p_Parent_Frame;
        hung.X_Parent_Frame.linear() = rotation.normalized().toRotationMatrix();
        m_frames.insert_or_assign(name, std::move(hung));
    }
}

std::optional<FrameTree::Place> FrameTree::placeOf(const std::string& frame,
                                                   const arm_model::ArmModel& model) const {
    std::string name = nameOf(frame.c_str());
    Place place;
    for (int step = 0; step < kLongestWay; ++step) {
        if (const std::optional<std::size_t> link = model.findLink(name)) {
            place.link = *link;
            return place;
        }
        const auto found = m_frames.find(name);
        if (found == m_frames.end())
            return std::nullopt;
        const Hung& hung = found->second;
        place.X_Link_Frame = hung.X_Parent_Frame * place.X_Link_Frame;
        if (hung.read_ns)
            place.read_ns = std::min(place.read_ns.value_or(*hung.read_ns), *hung.read_ns);
        name = hung.parent;
    }
    return std::nullopt; // they hang on each other
}

std::vector<FrameTree::Step> FrameTree::wayFrom(const std::string& frame) const {
    std::vector<Step> way(1);
    way.front().frame = nameOf(frame.c_str());
    for (int step = 0; step < kLongestWay; ++step) {
        const auto found = m_frames.find(way.back().frame);
        if (found == m_frames.end())
            break;
        const Hung& hung = found->second;
        Step next{hung.parent, hung.X_Parent_Frame * way.back().X_Step_Start, way.back().stamps_s};
        if (hung.read_ns)
            next.stamps_s.push_back(hung.stamp_s);
        way.push_back(std::move(next));
    }
    return way;
}

std::optional<FrameTree::Pose> FrameTree::between(const std::string& from, const std::string& to) const {
    const std::vector<Step> fromWay = wayFrom(from);
    for (const Step& up : wayFrom(to)) {
        const auto meets = std::ranges::find(fromWay, up.frame, &Step::frame);
        if (meets == fromWay.end())
            continue;
        Pose pose;
        pose.X_From_To = meets->X_Step_Start.inverse() * up.X_Step_Start;
        std::vector<double> stamps_s = meets->stamps_s;
        stamps_s.insert(stamps_s.end(), up.stamps_s.begin(), up.stamps_s.end());
        if (!stamps_s.empty()) {
            const auto [oldest, newest] = std::ranges::minmax(stamps_s);
            pose.stamp_s = newest;
            pose.oldestBy_s = newest - oldest;
        }
        return pose;
    }
    return std::nullopt;
}

} // namespace teleta::ros_arm
