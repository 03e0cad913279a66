// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/felt/felt_task.h"
#include "backend/study/methods/results/bracelet_results.h"
#include "backend/study/methods/results/threshold_results.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::study {

/// A threshold as the motors do it; or of a comparison the level that feels equal.
struct FeltStrength {
    std::string participant; ///< empty: the mean of all
    std::string condition;
    std::string track;
    double level = 0.0;
    MotorStrength strength;
    std::optional<double>
        weberSpeed; ///< of comparisons: speed at reference + JND over that at the reference, - 1
    std::optional<double> weberForce;
};

/// All thresholds of a task whose levels are intensities, where the motors of the track were measured.
/// Thread: any (pure).
[[nodiscard]] std::vector<FeltStrength> feltStrengths(const ThresholdResults& results, const FeltTask& felt,
                                                      const pattern::MotorProfiles& motors);

/// Where most answers were yes, of a task that varies the time from burst to burst at constant levels.
struct FeltOnset {
    std::string participant; ///< empty: the mean of all
    std::string condition;
    std::string track;
    BestOnset best;               ///< of the mean: onset and t interval alone
    std::size_t participants = 1; ///< with a best onset
    std::optional<double> law_s;  ///< by the law of apparent motion
};

/// Empty for other tasks. Thread: any (pure).
[[nodiscard]] std::vector<FeltOnset> feltOnsets(const ThresholdResults& results, const FeltTask& felt);

/// How many intensities the participants, and with the mean differences all of them (participant empty), can
/// tell apart. Empty for other tasks than comparisons of intensities, and where the reference is felt
/// elsewhere. Thread: any (pure).
[[nodiscard]] std::vector<StepsLine> feltSteps(const ThresholdResults& results, const FeltTask& felt);

} // namespace teleta::study
