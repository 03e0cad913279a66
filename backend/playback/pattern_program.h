// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/motor_model.h"
#include "backend/pattern/pattern.h"
#include "backend/playback/player_types.h"

namespace teleta::playback {

/// A pattern as it can be played, in the form made for many calls. Later changes of the pattern do not reach
/// it. Thread: any.
[[nodiscard]] Program programOf(const pattern::Pattern& pattern);

/// How the player maps intensities for these motors: from start to full drive where somebody has measured
/// them, else the board's own way. Thread: any (pure).
[[nodiscard]] DriveRanges rangesOf(const pattern::MotorProfiles& motors);

} // namespace teleta::playback
