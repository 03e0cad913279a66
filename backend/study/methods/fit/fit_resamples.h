// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/fit/psychometric_fit.h"

#include <cstddef>
#include <span>

namespace teleta::study {

/// The note of counts that need no search: noData, levelsNotAbove0, falls, tooFewLevels; otherwise none.
[[nodiscard]] FitNote quickNote(std::span<const LevelCount> counts, const FitModel& model);

/// noRise, belowRange, aboveRange: what refuses the numbers of a search; otherwise none. Thread: any.
[[nodiscard]] FitNote outsideNote(const LikelihoodSearch& search, const SearchPoint& best,
                                  std::span<const LevelCount> counts, const FitModel& model);

struct BootstrapThreshold {
    OpenInterval interval; ///< empty where more than 5 % are refused
    std::size_t refused = 0;
};

/// Interval of the threshold: data sets drawn from the function with the same trials, each fitted again; the
/// 2.5 % and 97.5 % quantiles (type 7) of their thresholds. Depends on settings.seed. Thread: any. Source:
/// Wichmann and Hill 2001, doi:10.3758/BF03194545.
[[nodiscard]] BootstrapThreshold bootstrapThreshold(std::span<const LevelCount> counts,
                                                    const PsychometricFunction& function,
                                                    const FitSettings& settings);

/// Goodness of fit by data sets drawn from the function and fitted again. deviance: of the fit. Thread: any.
/// Source: Wichmann and Hill 2001, doi:10.3758/BF03194544.
[[nodiscard]] GoodnessOfFit goodnessOfFit(std::span<const LevelCount> counts,
                                          const PsychometricFunction& function, double deviance,
                                          const FitSettings& settings);

} // namespace teleta::study
