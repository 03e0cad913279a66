// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/adaptive/track.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace teleta::study {

/// What a staircase did.
struct StaircaseTrack {
    std::vector<double> levels; ///< that the rules ask for, one a counted trial, in the unit of the level
    std::vector<std::size_t> reversals; ///< indices of the counted trials that caused one
    TrackStep next;                     ///< the next level or the end
};

/// Runs the rules over the trials that count. A move against the last one is a reversal, at the level of the
/// trial that caused it. Before `fastReversals` of them steps are `fastFactor` times larger; the move that
/// makes a reversal already has the size that its count gives. A move clears the row of correct answers. The
/// range cuts moves off; such a move counts, and three in a row that change nothing end the track (atFloor,
/// atCeiling). The estimate is the mean, on the scale, of the reversals after `skipReversals`, the earliest
/// left out when their number is odd; fewer than two: tooFewReversals. Trials after the end are ignored.
/// settings: without a settingsFault(). Thread: any. Sources: Levitt 1971, doi:10.1121/1.1912375; Kaernbach
/// 1991, doi:10.3758/BF03214307; Garcia-Perez 1998, doi:10.1016/S0042-6989(97)00340-4 (ratios of steps).
[[nodiscard]] StaircaseTrack staircaseTrack(const StaircaseSettings& settings, const LevelRange& range,
                                            std::span<const KeptTrial> kept);

/// The estimate that these reversals (levels, in their order) give; empty with fewer than two after the
/// skipped ones. Thread: any.
[[nodiscard]] std::optional<double> reversalEstimate(const StaircaseSettings& settings, LevelScale scale,
                                                     std::span<const double> reversalLevels);

} // namespace teleta::study
