// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/trajectory_message.h"

#include <cmath>
#include <span>
#include <utility>

namespace teleta::ros_arm {

namespace {

ros::Duration durationOf(double time_s) {
    constexpr long long kSecond_ns = 1'000'000'000;
    const long long time_ns = std::llround(time_s * 1e9);
    return {static_cast<std::int32_t>(time_ns / kSecond_ns),
            static_cast<std::uint32_t>(time_ns % kSecond_ns)};
}

} // namespace

TrajectoryMessage::TrajectoryMessage(std::vector<std::string> names)
    : m_names(std::move(names)) {
    for (std::string& name : m_names)
        m_pointers.push_back(name.data());
    m_message.header.frame_id = m_noFrame.data();
    ros::lend(m_message.joint_names, std::span(m_pointers));
    ros::lend(m_message.points, std::span(m_points));
}

const ros::JointTrajectory& TrajectoryMessage::fill(const std::array<arm_model::TrajectoryPoint, 2>& points) {
    m_values = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        arm_model::TrajectoryPoint& value = m_values[i];
        ros::lend(m_points[i].positions, std::span(value.position.data(), value.position.size()));
        ros::lend(m_points[i].velocities, std::span(value.velocity.data(), value.velocity.size()));
        m_points[i].time_from_start = durationOf(value.time_s);
    }
    return m_message;
}

} // namespace teleta::ros_arm
