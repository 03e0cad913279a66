// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/fit/psychometric_fit.h"

#include "backend/core/quantile.h"
#include "backend/core/words.h"
#include "backend/study/methods/fit/fit_resamples.h"
#include "backend/study/methods/fit/profile_interval.h"

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

constexpr core::Words<FitNote, 10> kFitNotes{{"", "noData", "falls", "noRise", "belowRange", "aboveRange",
                                              "slopeAtLimit", "lapseAtLimit", "tooFewLevels",
                                              "levelsNotAbove0"}};
constexpr core::Words<FitInterval, 3> kFitIntervals{{"none", "profile", "bootstrap"}};

/// A spread at its limit loses less than this of the log likelihood against the best one.
constexpr double kFlat = 1e-6;

/// What the share of right answers, taken together, says where it does not rise with the level.
FitNote withoutRise(std::span<const LevelCount> counts, double guess) {
    std::int64_t correct = 0;
    std::int64_t trials = 0;
    for (const LevelCount& count : counts) {
        correct += count.correct;
        trials += count.trials;
    }
    const std::optional<Interval> share = clopperPearsonInterval(correct, trials);
    const double middle = (1.0 + guess) / 2.0;
    if (share && share->low > middle)
        return FitNote::belowRange;
    return share && share->high < middle ? FitNote::aboveRange : FitNote::noRise;
}

bool isStep(const LikelihoodSearch& search, const SearchPoint& best) {
    for (const double limit : {search.lowest()[SearchPoint::spread], search.highest()[SearchPoint::spread]}) {
        if (best.logLikelihood - search.bestWith(SearchPoint::spread, limit, best).logLikelihood < kFlat)
            return true;
    }
    return false;
}

OpenInterval inUnit(const OpenInterval& interval, const LikelihoodSearch& search) {
    OpenInterval converted;
    if (interval.low)
        converted.low = search.thresholdOf(*interval.low);
    if (interval.high)
        converted.high = search.thresholdOf(*interval.high);
    return converted;
}

std::optional<double> middleOf(const OpenInterval& interval, LevelScale scale) {
    if (!interval.low || !interval.high)
        return std::nullopt;
    return scale == LevelScale::log10 ? std::sqrt(*interval.low * *interval.high)
                                      : 0.5 * (*interval.low + *interval.high);
}

} // namespace

const char* toString(FitNote note) {
    return kFitNotes.of(note);
}

const char* toString(FitInterval interval) {
    return kFitIntervals.of(interval);
}

std::optional<FitInterval> fitIntervalOf(std::string_view word) {
    return kFitIntervals.find(word);
}

std::optional<PsychometricFunction> PsychometricFit::function(RiseShape shape) const {
    if (!threshold || !spread || !guess || !lapse)
        return std::nullopt;
    return PsychometricFunction{shape, *threshold, *spread, *guess, *lapse};
}

std::optional<double> PsychometricFit::justNoticeable(RiseShape shape) const {
    std::optional<PsychometricFunction> curve = function(shape);
    if (!curve)
        return std::nullopt;
    curve->guess = 0.0;
    curve->lapse = 0.0;
    return 0.5 * (*curve->levelOf(0.75) - *curve->levelOf(0.25));
}

std::optional<Interval> shareBand(const PsychometricFit& fit, const FitModel& model, double level) {
    const std::optional<PsychometricFunction> curve = fit.function(model.shape);
    if (!curve || !fit.covariance)
        return std::nullopt;
    const std::array<double, 3> at{LikelihoodSearch::usesLogarithm(model) ? std::log(curve->threshold)
                                                                          : curve->threshold,
                                   std::log(curve->spread), curve->lapse};
    Eigen::Vector3d slope;
    for (std::size_t i = 0; i < 3; ++i) {
        const double step = i == SearchPoint::threshold && !LikelihoodSearch::usesLogarithm(model)
                                ? 1e-5 * curve->spread
                                : 1e-5;
        std::array<double, 3> more = at;
        std::array<double, 3> less = at;
        more[i] += step;
        less[i] -= step;
        slope[static_cast<Eigen::Index>(i)] = (LikelihoodSearch::functionOf(model, more).shareAt(level) -
                                               LikelihoodSearch::functionOf(model, less).shareAt(level)) /
                                              (2.0 * step);
    }
    const double variance = slope.dot(*fit.covariance * slope);
    const double half = core::kNormalQuantile95 * std::sqrt(std::max(variance, 0.0));
    const double share = curve->shareAt(level);
    return Interval{std::max(0.0, share - half), std::min(1.0, share + half)};
}

FitNote quickNote(std::span<const LevelCount> counts, const FitModel& model) {
    if (counts.empty())
        return FitNote::noData;
    if ((model.scale == LevelScale::log10 || model.shape == RiseShape::weibull) && counts.back().level <= 0.0)
        return FitNote::levelsNotAbove0;
    if (trendZ(counts) < -1.96)
        return FitNote::falls;
    return counts.size() < model.freeParameters() ? FitNote::tooFewLevels : FitNote::none;
}

FitNote outsideNote(const LikelihoodSearch& search, const SearchPoint& best,
                    std::span<const LevelCount> counts, const FitModel& model) {
    if (2.0 * (best.logLikelihood - search.constantLikelihood()) < kChiSquare95)
        return withoutRise(counts, model.guess.value_or(0.0));
    const double threshold = search.thresholdOf(best.at[SearchPoint::threshold]);
    // A step may lie anywhere between its two levels, so that rounding alone can put it outside.
    const double rounding = 1e-9 * std::abs(threshold);
    if (threshold < counts.front().level - rounding)
        return FitNote::belowRange;
    return threshold > counts.back().level + rounding ? FitNote::aboveRange : FitNote::none;
}

PsychometricFit fitPsychometric(std::span<const LevelCount> counts, const FitSettings& settings) {
    const FitModel& model = settings.model;
    PsychometricFit fit;
    fit.note = quickNote(counts, model);
    fit.guess = model.guess;
    if (!model.lapseIsFree())
        fit.lapse = model.lapseLow;
    if (counts.empty())
        return fit;
    fit.levels = counts.size();
    fit.lowestLevel = counts.front().level;
    fit.highestLevel = counts.back().level;
    for (const LevelCount& count : counts)
        fit.trials += count.trials;
    fit.trend = trendZ(counts);
    if (fit.note != FitNote::none)
        return fit;

    const LikelihoodSearch search(counts, model);
    const SearchPoint best = search.best();
    fit.riseStatistic = std::max(0.0, 2.0 * (best.logLikelihood - search.constantLikelihood()));
    fit.note = outsideNote(search, best, counts, model);
    if (fit.note != FitNote::none)
        return fit;
    if (isStep(search, best))
        fit.note = FitNote::slopeAtLimit;
    else if (model.lapseIsFree() && best.at[SearchPoint::lapse] > model.lapseHigh - 1e-6)
        fit.note = FitNote::lapseAtLimit;

    const PsychometricFunction function = search.functionAt(best);
    if (fit.note == FitNote::slopeAtLimit) {
        const OpenInterval interval = inUnit(profileInterval(search, SearchPoint::threshold, best), search);
        const std::optional<double> middle = middleOf(interval, model.scale);
        if (middle && (*middle < fit.lowestLevel || *middle > fit.highestLevel)) {
            fit.note = *middle < fit.lowestLevel ? FitNote::belowRange : FitNote::aboveRange;
            return fit;
        }
        fit.thresholdInterval = interval;
        fit.threshold = middle;
    }
    fit.guess = function.guess;
    fit.lapse = function.lapse;
    fit.logLikelihood = best.logLikelihood;
    fit.deviance = std::max(0.0, 2.0 * (search.saturatedLikelihood() - best.logLikelihood));
    if (fit.note == FitNote::slopeAtLimit)
        return fit;
    fit.threshold = function.threshold;
    fit.spread = function.spread;
    fit.covariance = search.covarianceAt(best);
    if (settings.interval == FitInterval::profile) {
        fit.thresholdInterval = inUnit(profileInterval(search, SearchPoint::threshold, best), search);
        const OpenInterval spread = profileInterval(search, SearchPoint::spread, best);
        if (spread.low)
            fit.spreadInterval.low = std::exp(*spread.low);
        if (spread.high)
            fit.spreadInterval.high = std::exp(*spread.high);
    } else if (settings.interval == FitInterval::bootstrap) {
        const BootstrapThreshold bootstrap = bootstrapThreshold(counts, function, settings);
        fit.refusedResamples = bootstrap.refused;
        fit.thresholdInterval = bootstrap.interval;
    }
    if (settings.goodness)
        fit.goodness = goodnessOfFit(counts, function, *fit.deviance, settings);
    return fit;
}

} // namespace teleta::study
