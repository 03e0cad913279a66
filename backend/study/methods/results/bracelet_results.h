// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/bracelet/best_onset.h"
#include "backend/study/methods/results/threshold_results.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// How many intensities a participant can tell apart, from the start of the motor (0) to its full drive (1).
struct StepsLine {
    std::string participant; ///< empty: with the mean just noticeable differences of all
    std::string task;
    std::string track;
    std::size_t references = 0;       ///< with a just noticeable difference
    std::size_t wanted = 0;           ///< references of the task
    std::optional<std::size_t> steps; ///< empty: one of them has none
};

/// Of comparisons of intensities with at least two references, each a condition. Thread: any (pure).
[[nodiscard]] std::vector<StepsLine> intensityStepsOf(const ThresholdResults& results);
/// The same of all participants together.
[[nodiscard]] std::vector<StepsLine> meanIntensityStepsOf(const ThresholdResults& results);

/// The time from burst to burst at which most answers were yes.
struct OnsetLine {
    std::string participant;
    std::string task;
    std::string condition;
    std::string track;
    BestOnset best;
};

/// Of yes_no with constant times: what was asked about them need not rise with the time. Thread: any (pure).
[[nodiscard]] std::vector<OnsetLine> bestOnsetsOf(const ThresholdResults& results);

} // namespace teleta::study
