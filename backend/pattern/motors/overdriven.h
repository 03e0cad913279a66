// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"

namespace teleta::pattern {

/// The pattern with its motors helped up: while a motor is to speed up its intensity is 1 until its model has
/// 90 % of the wanted speed, for no longer than Overdrive allows (MotorProfile::longestOverdrive_s). That is
/// decided every kOverdriveStep_s, as often as frames are sent, and holds until the next; a motor that is to
/// be off then stays off. Objects become breakpoints; where no motor needs help the pattern stays as it is.
/// Like any pattern it is played above the safety limits, which hold. profiles: valid().
/// Error: refused when it is longer than kLongestOverdriven_s or takes too many breakpoints.
/// Thread: any (pure).
[[nodiscard]] core::Expected<Pattern> overdriven(const Pattern& pattern, const MotorProfiles& profiles);

inline constexpr double kOverdriveStep_s = 0.005;
inline constexpr double kLongestOverdriven_s = 600.0;

} // namespace teleta::pattern
