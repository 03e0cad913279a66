// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/check/frame_check.h"

#include "backend/core/steady_time.h"
#include "backend/ros/qos_profile.h"
#include "backend/ros/topic_names.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::ros_arm {

namespace {

/// Of messages that wait, as ROS keeps of both topics.
constexpr int kMostAtOnce = 100;
/// A stamp in s since 1970 has steps of a quarter of a microsecond.
constexpr double kStampRounding_s = 1e-6;

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
    if (!m_joints.empty() && stamp_s <= m_joints.back().stamp_s)
        return;
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

core::Expected<FrameReaders> FrameReaders::open(const std::shared_ptr<const dds::Participant>& participant) {
    TELETA_TRY(auto fixed, dds::Reader<ros::TFMessage>::open(participant, ros::ddsTopicOf("/tf_static"),
                                                             ros::kLatchedReader.withDepth(kMostAtOnce)));
    TELETA_TRY(auto moving, dds::Reader<ros::TFMessage>::open(participant, ros::ddsTopicOf("/tf"),
                                                              ros::kSensorReader.withDepth(kMostAtOnce)));
    return FrameReaders{std::move(fixed), std::move(moving)};
}

void FrameReaders::take(FrameCheck& check) {
    (void)fixed.take(
        [&check](const ros::TFMessage& message, const dds::SampleInfo&) { check.takeFixed(message); });
    (void)moving.take([&check](const ros::TFMessage& message, const dds::SampleInfo&) {
        check.takeMoving(message, core::steadyNow_ns());
    });
}

} // namespace teleta::ros_arm
