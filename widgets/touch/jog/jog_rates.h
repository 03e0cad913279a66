// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"

#include <Eigen/Core>

namespace teleta::touch {

/// Speed of the arm's tip at full jog speed along an axis.
inline constexpr double kFullTipSpeed_mPerS = 0.25;

/// Joint rates that move the tip of the forearm with a velocity in the base frame.
///   rate = J^T (J J^T + d^2 I)^-1 v,   d = 0.02 m
/// so that near a stretched arm the joints do not race; then all are scaled down together until none is
/// faster than the description allows, which keeps the direction. Zero when an angle or the velocity is not
/// finite, or a link has no length. Thread: any (pure). Source: Nakamura and Hanafusa (1986).
[[nodiscard]] core::JointArray tipRates(const core::ArmDescription& arm, const core::JointArray& angle_rad,
                                        const Eigen::Vector3d& velocity_mPerS);

/// The tip of the forearm, in the base; not finite where an angle is not. Thread: any (pure).
[[nodiscard]] Eigen::Vector3d tipPosition(const core::ArmDescription& arm, const core::JointArray& angle_rad);

} // namespace teleta::touch
