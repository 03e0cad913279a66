// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/trajectory_points.h"
#include "backend/ros/messages.h"

#include <array>
#include <string>
#include <vector>

namespace teleta::ros_arm {

/// A message for a trajectory controller, which names all joints and is filled anew for each command.
/// Thread: one; fill() does not allocate.
class TrajectoryMessage {
public:
    /// names: of the joints on the wire, in the arm's order.
    explicit TrajectoryMessage(std::vector<std::string> names);
    TrajectoryMessage(const TrajectoryMessage&) = delete;
    TrajectoryMessage& operator=(const TrajectoryMessage&) = delete;

    /// Its stamp is 0: the controller begins at once. Valid until the next call. points: as many numbers as
    /// names, times rising from 0.
    [[nodiscard]] const ros::JointTrajectory& fill(const std::array<arm_model::TrajectoryPoint, 2>& points);

private:
    std::vector<std::string> m_names;
    std::vector<char*> m_pointers;
    std::array<arm_model::TrajectoryPoint, 2> m_values;
    std::array<ros::JointTrajectoryPoint, 2> m_points{};
    std::array<char, 1> m_noFrame{};
    ros::JointTrajectory m_message{};
};

} // namespace teleta::ros_arm
