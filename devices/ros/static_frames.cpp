// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/static_frames.h"

#include <utility>

namespace teleta::ros_arm {

namespace {

constexpr double kShortestQuaternion = 1e-6;

/// Older programs write a slash before the name.
std::string nameOf(const char* text) {
    std::string name = text == nullptr ? "" : text;
    if (name.starts_with('/'))
        name.erase(0, 1);
    return name;
}

} // namespace

void StaticFrames::take(const ros::TFMessage& message) {
    for (const auto& told : ros::view(message.transforms)) {
        const auto& [x, y, z] = told.transform.translation;
        const auto& turn = told.transform.rotation;
        const Eigen::Vector3d p_Parent_Frame(x, y, z);
        const Eigen::Quaterniond rotation(turn.w, turn.x, turn.y, turn.z);
        const std::string name = nameOf(told.child_frame_id);
        const bool isUsable = p_Parent_Frame.allFinite() && rotation.coeffs().allFinite() &&
                              rotation.norm() > kShortestQuaternion && !name.empty();
        if (!isUsable || (m_frames.size() >= kMostFrames && !m_frames.contains(name)))
            continue;
        Hung hung{nameOf(told.header.frame_id), Eigen::Isometry3d::Identity()};
        hung.X_Parent_Frame.translation() = p_Parent_Frame;
        hung.X_Parent_Frame.linear() = rotation.normalized().toRotationMatrix();
        m_frames.insert_or_assign(name, std::move(hung));
    }
}

std::optional<StaticFrames::Place> StaticFrames::placeOf(const std::string& frame,
                                                         const arm_model::ArmModel& model) const {
    std::string name = nameOf(frame.c_str());
    Place place;
    for (int step = 0; step < kLongestWay; ++step) {
        if (const std::optional<std::size_t> link = model.findLink(name)) {
            place.link = *link;
            return place;
        }
        const auto hung = m_frames.find(name);
        if (hung == m_frames.end())
            return std::nullopt;
        place.X_Link_Frame = hung->second.X_Parent_Frame * place.X_Link_Frame;
        name = hung->second.parent;
    }
    return std::nullopt; // they hang on each other
}

} // namespace teleta::ros_arm
