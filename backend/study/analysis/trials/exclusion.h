// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/exclusion_rule.h"
#include "backend/study/protocol/trial.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace teleta::study {

/// What the rules have to know of a completed trial of one participant.
struct ExcludableTrial {
    std::string_view task;
    std::string_view condition;
    std::string_view session; ///< its id
    Phase phase = Phase::test;
    std::string_view stimulus;
    std::string_view response; ///< empty: none in time
    std::optional<double> responseTime_s;
    std::size_t deviceFaults = 0;
    std::size_t framesMissed = 0;
    double chance = 0.0; ///< of a right answer by guessing; 0: answers of this trial are not scored

    [[nodiscard]] bool isCorrect() const { return stimulus == response; }
    /// Nothing was there to be felt, and the question was whether something was.
    [[nodiscard]] bool isCatch() const { return stimulus == "no"; }
};

/// What a rule did to one participant.
struct ExclusionCount {
    std::size_t trialsBefore = 0;       ///< left by the rules before
    std::size_t trials = 0;             ///< excluded
    std::size_t sessions = 0;           ///< excluded as a whole
    bool participant = false;           ///< excluded as a whole
    std::size_t cellsWithoutSpread = 0; ///< response_time_mad: MAD of 0, so that nothing was excluded
};

struct Exclusions {
    std::vector<std::optional<std::size_t>> rule; ///< per trial: which rule excluded it
    std::vector<ExclusionCount> counts;           ///< per rule
};

/// Applies the rules in their order to the trials of one participant; each sees what those before have left.
/// Rules about trials and sessions look at test trials, and leave out whole sessions with their practice;
/// rules about times at answered ones. The chance of a participant is the sum over tasks of binomial guesses,
/// exactly. Thread: any (pure).
[[nodiscard]] Exclusions applyExclusions(std::span<const ExclusionRule> rules,
                                         std::span<const ExcludableTrial> trials);

/// Limits of response_time_mad, in seconds: exp(median -+ value * 1.4826 MAD) of the logarithms. Empty
/// without times above 0, and with MAD 0. Source: Leys et al. 2013, doi:10.1016/j.jesp.2013.03.013.
struct TimeLimits {
    double low_s = 0.0;
    double high_s = 0.0;
};
[[nodiscard]] std::optional<TimeLimits> madLimits(std::span<const double> times_s, double value);

} // namespace teleta::study
