// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <array>

namespace teleta::pattern {

// Steps of an editor as functions from pattern to pattern; objects stay objects. Thread: any (pure).

/// Everything turned around the forearm: what tactor i did, tactor i + steps does. Of a stroke the rows
/// change places with an odd number of steps.
[[nodiscard]] Pattern rotated(const Pattern& pattern, int steps);

/// Everything mirrored around the forearm: tactor i and tactor axis - i change places, so an even axis goes
/// through tactor axis / 2, an odd one between two tactors. Rings run the other way round.
[[nodiscard]] Pattern mirrored(const Pattern& pattern, int axis);

/// The pattern for the other arm, where counter-clockwise is inwards instead of outwards.
[[nodiscard]] Pattern forOtherArm(const Pattern& pattern);

/// All times multiplied. Onsets and bursts that the law of apparent motion gives follow the law, not the
/// factor. Error: refused: a factor that is not positive and finite, or a result longer than
/// Pattern::kLongest_s.
[[nodiscard]] core::Expected<Pattern> stretched(const Pattern& pattern, double factor);

/// true: the tactor is meant.
using TactorSet = std::array<bool, core::kTactors>;
inline constexpr TactorSet kAllTactors{true, true, true, true, true, true};

/// A piece of tracks; times count from its begin.
struct Clip {
    double duration_s = 0.0;
    TactorSet tactors{};
    Tracks tracks;
};

/// What the tracks (not the objects) of some tactors do in a range. Eased segments that the range cuts become
/// lines within kBakeTolerance. A range that is empty or no range gives an empty clip.
[[nodiscard]] Clip copied(const Pattern& pattern, const Span& range, const TactorSet& tactors = kAllTactors);

/// The same tracks silent in a range; nothing moves.
[[nodiscard]] Pattern erased(const Pattern& pattern, const Span& range,
                             const TactorSet& tactors = kAllTactors);

/// The clip in place of what its tactors did from a time on; the pattern gets longer when it must. begin_s:
/// >= 0, otherwise nothing changes.
[[nodiscard]] Pattern pasted(const Pattern& pattern, const Clip& clip, double begin_s);

} // namespace teleta::pattern
