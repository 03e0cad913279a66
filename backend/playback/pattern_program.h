// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"
#include "backend/playback/player_types.h"

namespace teleta::playback {

/// A pattern compiled for many evaluations; later changes to the pattern do not affect it. Thread: any.
[[nodiscard]] Program programOf(const pattern::Pattern& pattern);

/// Where to start a program so that it is felt as soon as possible: at the second frame if only the first one
/// is off, otherwise at 0. rate_Hz: of the frames, > 0. Calls evaluate; 0 if there is none or if it throws.
/// Thread: any.
[[nodiscard]] double promptBegin_s(const Program& program, double rate_Hz);

/// How the player maps intensities for these motors: from start to full drive where they were measured,
/// otherwise in the board's own way. Thread: any (pure).
[[nodiscard]] DriveRanges rangesOf(const pattern::MotorProfiles& motors);

} // namespace teleta::playback
