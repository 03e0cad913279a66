// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

namespace teleta::pattern {

// Editing operations as functions from pattern to pattern; objects stay objects. Thread: any (pure).

/// Rotates the pattern around the forearm: tactor i + steps does what tactor i did. An odd number of steps
/// swaps the rows of a stroke.
[[nodiscard]] Pattern rotated(const Pattern& pattern, int steps);

/// Mirrors the pattern: tactors i and axis - i change places, so that an even axis runs through tactor axis /
/// 2 and an odd one between two tactors. Rings change their direction.
[[nodiscard]] Pattern mirrored(const Pattern& pattern, int axis);

/// Converts the pattern for the other arm, on which counter-clockwise is inwards instead of outwards.
[[nodiscard]] Pattern forOtherArm(const Pattern& pattern);

/// Multiplies all times. Onsets and bursts given by the law of apparent motion follow the law, not the
/// factor. Error: refused: the factor is not positive and finite, or the result is longer than
/// Pattern::kLongest_s.
[[nodiscard]] core::Expected<Pattern> stretched(const Pattern& pattern, double factor);

} // namespace teleta::pattern
