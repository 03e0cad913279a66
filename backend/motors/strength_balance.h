// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/motors/motor_model.h"

#include <cstddef>

namespace teleta::motors {

/// Sets the full drives so that all motors reach the same speed, that of the slowest one at its full drive;
/// motors of the same type are then equally strong. Motors whose curve is assumed keep their full drive and
/// are not taken into account. A motor that cannot be slowed down that far gets a full drive just above its
/// start. motors: valid(). Thread: any (pure).
[[nodiscard]] pattern::MotorProfiles balancedBySpeed(pattern::MotorProfiles motors);

/// Sets the full drives from the drives at which a person felt each motor to be as strong as the reference:
///   full_i = equal_i / max_j equal_j
/// so that none exceeds 1. A full drive at or below the start of its motor is raised to just above it. equal:
/// > 0; for the reference the drive at which it was presented. Thread: any (pure).
[[nodiscard]] pattern::MotorProfiles balancedByFeel(pattern::MotorProfiles motors,
                                                    const core::Intensities& equal);

} // namespace teleta::motors
