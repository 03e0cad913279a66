// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"

namespace teleta::pattern {

/// Adds overdrive to a pattern: while a motor speeds up, its intensity is 1 until its model has reached 90 %
/// of the desired speed, as long as Overdrive allows it (MotorProfile::longestOverdrive_s). This is decided
/// every kOverdriveStep_s, the period of the frames sent to the bracelet; a motor that must be off stays off.
/// Objects become breakpoints; where no motor needs overdrive the pattern is not changed. The safety limits
/// of the player apply as to any pattern. profiles: valid(). Error: refused when the pattern is longer than
/// kLongestOverdriven_s or needs too many breakpoints. Thread: any (pure).
[[nodiscard]] core::Expected<Pattern> overdriven(const Pattern& pattern, const MotorProfiles& profiles);

inline constexpr double kOverdriveStep_s = 0.005;
inline constexpr double kLongestOverdriven_s = 600.0;

} // namespace teleta::pattern
