// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/adaptive/procedure_settings.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

namespace teleta::study {

/// A trial of a track that was shown, answered and kept.
struct KeptTrial {
    double level = 0.0;     ///< as shown, in the unit of the level
    std::size_t answer = 0; ///< index of the design's answers
    /// What speaks for a lower threshold: a right answer; "yes"; "different"; in comparisons "the varied one
    /// is stronger".
    bool correct = false;
    bool counts = true; ///< false: a catch or same trial, which the procedure passes over
};

/// Why a track is over.
enum class EndReason {
    allShown,    ///< constant stimuli: every level as often as planned
    reversals,   ///< staircase
    mostTrials,  ///< staircase, bayes
    precision,   ///< bayes: the sd of the threshold is small enough
    atFloor,     ///< staircase: three moves in a row that the lowest level cut off
    atCeiling,   ///< staircase: the same with the highest level
    badSettings, ///< nothing can be shown with these settings, see settingsFault()
};

/// Why a track that is over has no estimate, or one that is a bound.
enum class TrackNote {
    none,
    atFloor,         ///< staircase, no estimate
    atCeiling,       ///< staircase, no estimate
    tooFewReversals, ///< staircase, no estimate
    belowRange,      ///< bayes: the two lowest thresholds of the grid hold half of the mass or more
    aboveRange,      ///< bayes: the two highest
};

/// Words in files: "allShown", .. and "", "atFloor", .. Thread: any.
[[nodiscard]] const char* toString(EndReason reason);
[[nodiscard]] const char* toString(TrackNote note);

/// The track goes on with this level.
struct NextLevel {
    double level = 0.0; ///< in the unit of the level
};

/// The track is over.
struct TrackEnd {
    EndReason reason = EndReason::mostTrials;
    std::optional<double> estimate = {}; ///< of the threshold, in the unit of the level; constant: none
    std::optional<double> sd = {};       ///< bayes, on the scale
    std::optional<double> low = {};      ///< bayes, 95 % interval, in the unit of the level
    std::optional<double> high = {};
    TrackNote note = TrackNote::none;
};

using TrackStep = std::variant<NextLevel, TrackEnd>;

/// What is wrong with settings, in English, with the key's name in files; empty: nothing. Whoever reads
/// settings asks this. Thread: any.
[[nodiscard]] const char* settingsFault(const Procedure& procedure, const LevelRange& range);

/// What comes after these trials: the next level, or the end with its estimate. Depends on its arguments
/// alone, so that an interrupted track goes on as if it had not been. seed: the track's (constant stimuli
/// shuffle with it; the other procedures draw nothing). A staircase follows answers only; bayes also uses the
/// levels, as shown. Thread: any. Takes milliseconds.
[[nodiscard]] TrackStep nextStep(const Procedure& procedure, const LevelRange& range, std::uint64_t seed,
                                 std::span<const KeptTrial> kept);

/// The first kept trial whose level is not the one that the procedure gives after those before it (relative
/// difference over 1e-9), or that came after the end of the track; empty: none. Trials that do not count are
/// not compared. Thread: any.
[[nodiscard]] std::optional<std::size_t> firstForeignTrial(const Procedure& procedure,
                                                           const LevelRange& range, std::uint64_t seed,
                                                           std::span<const KeptTrial> kept);

} // namespace teleta::study
