// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/joint_vector.h"

#include <array>

namespace teleta::arm_model {

/// A point of a trajectory: where each joint is and how fast, so long after the command.
struct TrajectoryPoint {
    double time_s = 0.0;
    core::JointVector position; ///< rad, prismatic m
    core::JointVector velocity;
};

/// Time from a command to its first point: two periods of 50 Hz.
inline constexpr double kFirstPoint_s = 0.04;

/// The two points that are sent to a trajectory controller with each command, so that the arm comes to rest
/// by itself when no further command comes:
///   point 1 at T1:       q_c + v T1,                    velocity v
///   point 2 at T1 + Tb:  q_c + v T1 + v |v| / (2 a),    velocity 0;   Tb = max |v_j| / a_j
/// commanded: q_c, the commanded position, not the measured one, from which each command would restart where
/// the arm lags. rate: v, finite. deceleration: a, > 0, one a joint. When nothing moves, the second point
/// comes kFirstPoint_s after the first, since times must rise. A joint that is slower than the slowest to
/// stop reaches its end with velocity 0 at the same time. Thread: any (pure). Source: ros2_controllers,
/// joint_trajectory_controller (checks of a trajectory).
[[nodiscard]] std::array<TrajectoryPoint, 2> trajectoryPoints(const core::JointVector& commanded,
                                                              const core::JointVector& rate,
                                                              const core::JointVector& deceleration);

} // namespace teleta::arm_model
