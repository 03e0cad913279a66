// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"

#include <Eigen/Core>

#include <cstddef>

namespace teleta::arm {

/// Speed of the arm's tip at full jog speed along an axis.
inline constexpr double kFullTipSpeed_mPerS = 0.25;

/// Joint rates that move the tip of the forearm with a velocity in the base frame.
///   rate = J^T (J J^T + d^2 I)^-1 v,   d = 0.02 m
/// so that near a stretched arm the joints do not race; then all are scaled down together until none is
/// faster than the description allows, which keeps the direction. Zero when an angle or the velocity is not
/// finite, a link has no length, or the arm is none of Arm4Kinematics. Thread: any (pure). Source:
/// Nakamura and Hanafusa (1986).
[[nodiscard]] core::JointVector tipRates(const core::ArmDescription& arm, const core::JointVector& angle_rad,
                                         const Eigen::Vector3d& velocity_mPerS);

/// The tip of an arm with so many joints can be moved: it is one of Arm4Kinematics.
[[nodiscard]] bool canMoveTip(std::size_t joints);

/// The tip of the forearm, in the base; not finite where an angle is not. Thread: any (pure).
[[nodiscard]] Eigen::Vector3d tipPosition(const core::ArmDescription& arm,
                                          const core::JointVector& angle_rad);

} // namespace teleta::arm
