// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/motors/motor_model.h"

#include <cstddef>

namespace teleta::motors {

/// Full drives at which all motors reach the same speed, that of the slowest one at its full drive: of equal
/// motors, equal strength. Motors whose curve is assumed keep their full drive and do not count. A motor that
/// cannot be slowed down so far ends just above its start. motors: valid(). Thread: any (pure).
[[nodiscard]] pattern::MotorProfiles balancedBySpeed(pattern::MotorProfiles motors);

/// Full drives from the drives at which a person felt each motor as strong as the reference at its own:
///   full_i = equal_i / max_j equal_j
/// so that none is above 1. A result at or below the start of its motor ends just above it. equal: > 0; that
/// of the reference is the drive at which it was presented. Thread: any (pure).
[[nodiscard]] pattern::MotorProfiles balancedByFeel(pattern::MotorProfiles motors,
                                                    const core::Intensities& equal);

} // namespace teleta::motors
