// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"
#include "backend/study/methods/fit/likelihood_search.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace teleta::study {

/// What a fit has to say besides its numbers.
enum class FitNote {
    none,
    noData,         ///< no trial; no numbers
    falls,          ///< worse with more of it: levels or answers swapped? No numbers
    noRise,         ///< no dependence on the level; no numbers
    belowRange,     ///< threshold below the lowest level, which is a bound; no numbers
    aboveRange,     ///< threshold above the highest level, which is a bound; no numbers
    slopeAtLimit,   ///< a step between two levels: the threshold is the middle of its interval, no spread
    lapseAtLimit,   ///< many lapses, or no upper end of the curve
    tooFewLevels,   ///< fewer levels than free parameters; no numbers. A fixed lapse rate needs one less
    levelsNotAbove0 ///< a logarithmic scale, or weibull, without a level above 0; no numbers
};

/// "", "noData", "falls", .. as in files. Thread: any.
[[nodiscard]] const char* toString(FitNote note);

/// How the interval of a threshold is computed.
enum class FitInterval {
    none,
    profile,   ///< all values with 2 (Lmax - Lprofile) <= 3.841459
    bootstrap, ///< parametric, percentiles
};

/// "none", "profile", "bootstrap", as in files. Thread: any.
[[nodiscard]] const char* toString(FitInterval interval);
/// The inverse; empty for any other word. Thread: any.
[[nodiscard]] std::optional<FitInterval> fitIntervalOf(std::string_view word);

/// An interval whose ends may be open: empty where the limits of the parameter are reached first.
struct OpenInterval {
    std::optional<double> low;
    std::optional<double> high;
};

struct FitSettings {
    FitModel model;
    FitInterval interval = FitInterval::profile;
    bool goodness = false; ///< p of the deviance; for constant stimuli only
    std::size_t resamples = 2000;
    std::uint64_t seed = 1; ///< of resamples
};

/// How well a fit describes its data; p from data sets drawn from the fit and fitted again, never from the
/// chi-square table.
struct GoodnessOfFit {
    double pDeviance = 1.0;                ///< (1 + #(D* >= D)) / (B + 1)
    std::optional<double> residualByShare; ///< correlation of deviance residuals with the fitted share
    std::optional<double> residualByOrder; ///< with the order of the levels
    std::optional<double>
        pResidualByShare; ///< share of resamples with a larger absolute correlation, two-sided
    std::optional<double> pResidualByOrder;
};

/// A psychometric function fitted to the trials of one participant, condition and track.
struct PsychometricFit {
    FitNote note = FitNote::noData;
    std::size_t levels = 0;
    std::int64_t trials = 0;
    double lowestLevel = 0.0;
    double highestLevel = 0.0;
    double trend = 0.0;              ///< z of the trend of the shares
    double riseStatistic = 0.0;      ///< 2 (Lmax - Lconstant)
    std::optional<double> threshold; ///< unit of the level
    OpenInterval thresholdInterval;  ///< 95 %
    std::optional<double> spread;    ///< s in the unit of the level, or b
    OpenInterval spreadInterval;     ///< 95 %, profile only
    std::optional<double> guess;     ///< also where it is fixed
    std::optional<double> lapse;
    std::optional<double> logLikelihood; ///< without the binomial coefficients
    std::optional<double> deviance;
    std::optional<GoodnessOfFit> goodness;
    /// Of threshold (its logarithm on a log10 scale and for weibull), logarithm of the spread, lapse rate.
    std::optional<Eigen::Matrix3d> covariance;
    std::size_t refusedResamples = 0; ///< bootstrap: of settings.resamples; over 5 %: no interval

    /// The function, where it has threshold and spread.
    [[nodiscard]] std::optional<PsychometricFunction> function(RiseShape shape) const;
    /// Half the distance between the levels where F is 1/4 and 3/4; empty without a function.
    [[nodiscard]] std::optional<double> justNoticeable(RiseShape shape) const;
};

/// Where the fitted share lies at a level, 95 %: share +- 1.96 sd by the delta method, within 0 .. 1. For
/// pictures; empty without a function or its covariance. Thread: any.
[[nodiscard]] std::optional<Interval> shareBand(const PsychometricFit& fit, const FitModel& model,
                                                double level);

/// Fits Psi = g + (1 - g - l) F by maximum likelihood to the counts of one participant. The note's order:
/// noData, levelsNotAbove0, falls (trend z < -1.96), tooFewLevels, then by 2 (Lmax - Lconstant) < 3.841459
/// and the exact interval of the pooled share against (1 + g)/2 noRise, belowRange, aboveRange; then a
/// threshold outside of the levels; slopeAtLimit; lapseAtLimit (l within 1e-6 of its upper limit). counts:
/// rising levels. Thread: any. Sources: Wichmann and Hill 2001, doi:10.3758/BF03194544 and
/// doi:10.3758/BF03194545.
[[nodiscard]] PsychometricFit fitPsychometric(std::span<const LevelCount> counts,
                                              const FitSettings& settings);

} // namespace teleta::study
