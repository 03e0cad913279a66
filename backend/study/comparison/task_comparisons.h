// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/comparison/paired_comparison.h"
#include "backend/study/comparison/rank_test.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// Two levels of an effect, compared within participants: by means and by ranks.
struct LevelPair {
    std::string effect;   ///< condition, pattern
    std::string stimulus; ///< compared within this pattern; empty: means over the other factor
    std::string first;
    std::string second;
    PairedComparison comparison; ///< of the shares of right answers, first - second
    std::optional<double> pHolm; ///< of comparison, over the family
    std::size_t family = 0;      ///< p values in the family
    tl::expected<SignedRankTest, Refusal> ranks;
    std::optional<double> ranksHolm; ///< of ranks, over the family
    std::size_t ranksFamily = 0;
};

/// What is added to a line of the ANOVA table.
struct EffectSupplement {
    std::string effect;
    std::string stimulus;
    std::optional<Interval> partialEta2; ///< empty also where sphericity does not hold: eps GG < 0.75
    std::string note;                    ///< why there is no interval; empty otherwise
    /// Of three and more levels; of two levels and of interactions empty.
    std::optional<tl::expected<FriedmanTest, Refusal>> friedman;
};

/// Comparisons of one task.
struct TaskComparisons {
    std::vector<LevelPair> pairs;
    std::vector<EffectSupplement> effects; ///< one per line of the ANOVA table, in its order
};

/// The smallest epsilon of Greenhouse and Geisser with which partial eta squared has an interval.
inline constexpr double kLeastSphericity = 0.75;

/// All pairs of levels of each line of the ANOVA table, interactions excepted. A family of p values is one
/// effect of the task; the comparisons of the conditions within each pattern are one family together.
/// Participants are those of the line. Empty for a task without lines. Thread: any.
[[nodiscard]] TaskComparisons taskComparisons(const TaskResults& task);

/// Holm's p of the conditions within this pattern; empty with other than two conditions and without p.
[[nodiscard]] std::optional<double> patternPHolm(const TaskComparisons& comparisons,
                                                 const std::string& pattern);

} // namespace teleta::study
