// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/check/frame_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace teleta::ros_arm {

namespace {

/// A stamp in s since 1970 has steps of a quarter of a microsecond.
constexpr double kStampRounding_s = 1e-6;
/// Poses of a later time are of another clock.
constexpr double kFarAhead_s = 5.0;

} // namespace

FrameCheck::FrameCheck(std::shared_ptr<const arm_model::SerialChain> chain)
    : m_chain(std::move(chain)) {
}

void FrameCheck::takeMoving(const ros::TFMessage& message, std::int64_t read_ns) {
    ++m_seen.messages;
    m_tree.takeMoving(message, read_ns);
    const auto pose = m_tree.between(m_chain->baseLink(), m_chain->tipLink());
    m_seen.connected = pose.has_value();
    if (!pose || pose->stamp_s == 0.0 || pose->oldestBy_s > kSameTime_s)
        return;
    if (!m_waiting.empty() && m_waiting.back().stamp_s == pose->stamp_s)
        m_waiting.pop_back(); // the same pose, and now more of it is known
    m_waiting.push_back(*pose);
    if (m_waiting.size() > kKept)
        m_waiting.pop_front();
}

void FrameCheck::takeJoints(const core::JointVector& position, double stamp_s) {
    if (!m_joints.empty() && stamp_s < m_joints.back().stamp_s - kLongestGap_s) {
        m_joints.clear(); // the robot's clock was set back
        m_waiting.clear();
    }
    if (!m_joints.empty() && stamp_s <= m_joints.back().stamp_s)
        return;
    std::erase_if(m_waiting,
                  [stamp_s](const FrameTree::Pose& pose) { return pose.stamp_s > stamp_s + kFarAhead_s; });
    // Poses that end here have been reported in full.
    compareWaiting();
    m_joints.push_back({stamp_s, position});
    if (m_joints.size() > kKept)
        m_joints.pop_front();
}

void FrameCheck::compareWaiting() {
    while (m_joints.size() > 1 && !m_waiting.empty() &&
           m_waiting.front().stamp_s <= m_joints.back().stamp_s + kStampRounding_s) {
        const FrameTree::Pose pose = m_waiting.front();
        m_waiting.pop_front();
        const auto after = std::ranges::lower_bound(m_joints, pose.stamp_s - kStampRounding_s, {},
                                                    [](const Joints& joints) { return joints.stamp_s; });
        if (after == m_joints.end() || (after == m_joints.begin() && after->stamp_s > pose.stamp_s))
            continue;
        if (std::abs(after->stamp_s - pose.stamp_s) <= kStampRounding_s) {
            compare(pose, after->position);
            continue;
        }
        const Joints& before = *std::prev(after);
        const double gap_s = after->stamp_s - before.stamp_s;
        if (gap_s > kLongestGap_s)
            continue;
        // Between two samples no joint turns by half a turn: it has come round.
        const auto jumps = [](double a, double b) { return std::abs(a - b) > std::numbers::pi; };
        if (!std::ranges::equal(before.position, after->position,
                                [&](double a, double b) { return !jumps(a, b); }))
            continue;
        const double share = (pose.stamp_s - before.stamp_s) / gap_s;
        core::JointVector position = before.position;
        for (std::size_t i = 0; i < position.size(); ++i)
            position[i] += share * (after->position[i] - before.position[i]);
        compare(pose, position);
    }
}

void FrameCheck::compare(const FrameTree::Pose& pose, const core::JointVector& position) {
    const Eigen::Isometry3d X_Own_Told = m_chain->X_Base_Tip(position).inverse() * pose.X_From_To;
    ++m_seen.compared;
    m_seen.farthest_m = std::max(m_seen.farthest_m, X_Own_Told.translation().norm());
    m_seen.largestTurn_rad =
        std::max(m_seen.largestTurn_rad, std::abs(Eigen::AngleAxisd(X_Own_Told.linear()).angle()));
}

} // namespace teleta::ros_arm
