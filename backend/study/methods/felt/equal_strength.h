// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/methods/felt/felt_task.h"
#include "backend/study/methods/fit/psychometric_fit.h"
#include "backend/study/methods/results/threshold_results.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// At which levels tactors feel as strong as one of them.
struct EqualStrength {
    std::size_t reference = 0; ///< tactor, from 0
    double referenceLevel = 0.0;
    std::array<std::optional<double>, core::kTactors>
        levels;                                         ///< empty: not measured; that of the reference too
    std::array<OpenInterval, core::kTactors> intervals; ///< 95 %
};

/// Of comparisons of intensities whose tracks are one tactor each against another one: for each condition and
/// tactor of the reference. participant: empty for the mean of all. Empty for other tasks. Thread: any
/// (pure).
[[nodiscard]] std::vector<EqualStrength> equalStrengths(const ThresholdResults& results, const FeltTask& felt,
                                                        const std::string& participant);

/// The motors with full drives at which all are equally strong (motors::balancedByFeel), from the drives at
/// which they felt so. motors: with which the levels were felt, valid(). Error: refused when a tactor has no
/// level, naming it, or when one cannot be lowered so far. Thread: any (pure).
[[nodiscard]] core::Expected<pattern::MotorProfiles>
balancedMotors(const EqualStrength& equal, double strongest, const pattern::MotorProfiles& motors);

/// Tactors about which two measurements with different references disagree: the drives of each, relative to
/// the tactor that is the reference of `second`, lie outside the other's interval, both ways. Without a level
/// on either side nothing is said of a tactor. Thread: any (pure).
[[nodiscard]] std::vector<std::size_t> disagreements(const EqualStrength& first, const EqualStrength& second,
                                                     double strongest, const pattern::MotorProfiles& motors);

} // namespace teleta::study
