// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/adaptive/psychometric_function.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace teleta::study {

/// The scale on which steps are counted and thresholds are averaged.
enum class LevelScale { linear, log10 };

/// "linear", "log10", as in files. Thread: any.
[[nodiscard]] const char* toString(LevelScale scale);
/// The inverse; empty for any other word. Thread: any.
[[nodiscard]] std::optional<LevelScale> levelScaleOf(std::string_view word);

/// Levels that a track may show, in the unit of the level.
struct LevelRange {
    LevelScale scale = LevelScale::log10;
    double lowest = 0.01; ///< > 0 with log10
    double highest = 1.0; ///< > lowest
};

/// The place of a level on its scale: the level, or its logarithm (-infinity for 0). Thread: any.
[[nodiscard]] double onScale(LevelScale scale, double level);
/// The inverse. Thread: any.
[[nodiscard]] double fromScale(LevelScale scale, double place);

/// The method of constant stimuli: every level equally often, in an order drawn from the track's seed.
struct ConstantSettings {
    std::vector<double> levels;  ///< rising
    std::size_t repetitions = 1; ///< of each level
    bool blocked = false;        ///< each repetition of all levels is shuffled by itself
};

/// A staircase: down after so many correct answers in a row, up after one wrong one. Steps are on the scale.
struct StaircaseSettings {
    double first = 0.8;   ///< level of the first trial, in the unit of the level
    std::size_t down = 2; ///< correct answers in a row for a move down, 1 .. 8
    double stepUp = 0.0911;
    double stepDown = 0.05;
    std::size_t fastReversals = 2; ///< until so many reversals steps are larger
    double fastFactor = 4.0;       ///< this many times, >= 1
    std::size_t reversals = 12;    ///< the track ends with this one
    std::size_t skipReversals = 4; ///< the estimate leaves out so many
    std::size_t mostTrials = 80;   ///< or with this trial, whichever is first
};

/// A Bayesian procedure (QUEST+): a grid of thresholds, slopes, lapse and guess rates.
struct BayesSettings {
    RiseShape function = RiseShape::weibull;
    std::vector<double> slope = {1.0, 1.5, 2.0, 3.0, 4.5, 6.0, 8.0, 10.0}; ///< b of weibull, else s
    std::vector<double> lapse = {0.0, 0.02, 0.04, 0.06};
    std::vector<double> guess = {0.5}; ///< one value 1/m where m intervals are offered
    bool guessIsLapse = false;         ///< g = l, and `guess` is not used (comparisons)
    std::size_t grid = 41;             ///< levels and thresholds, from the lowest to the highest on the scale
    std::optional<double> priorMean;   ///< on the scale; the prior of thresholds is flat without
    std::optional<double> priorSd;
    std::size_t mostTrials = 40;
    std::size_t leastTrials = 25;
    std::optional<double> sdAtMost; ///< on the scale: ends after leastTrials with so small a sd
};

using Procedure = std::variant<ConstantSettings, StaircaseSettings, BayesSettings>;

/// "constant", "staircase", "bayes", as in files. Thread: any.
[[nodiscard]] const char* nameOf(const Procedure& procedure);

/// The share of correct answers that a staircase tends to: p^down = up / (up + down). Thread: any. Source:
/// Levitt 1971, doi:10.1121/1.1912375; Kaernbach 1991, doi:10.3758/BF03214307.
[[nodiscard]] double targetShare(const StaircaseSettings& settings);

} // namespace teleta::study
