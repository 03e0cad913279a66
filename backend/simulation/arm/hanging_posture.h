// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"

namespace teleta::simulation {

/// Joint angles at which the forearm hangs straight down and the elbow, below the height of the shoulder, is
/// at (x, y) of the base:  z = -sqrt(L^2 - x^2 - y^2). Where that cannot be, at a distance from the vertical
/// axis through the shoulder below 0.02 L or above 0.98 L, the nearest place where it can; at the axis
/// itself, along x. L is the upper arm's length. Thread: any (pure).
[[nodiscard]] arm::JointVector hangingPosture(const arm::ArmDimensions& dimensions,
                                              const Eigen::Vector2d& p_Base_Elbow_m);

/// (x, y) of the elbow in the base. Thread: any (pure).
[[nodiscard]] Eigen::Vector2d elbowAt_m(const arm::Arm4Kinematics& kinematics, const arm::JointVector& q_rad);

} // namespace teleta::simulation
