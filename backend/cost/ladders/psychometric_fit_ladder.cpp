// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/quantile.h"
#include "backend/core/random_stream.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/study/methods/fit/fit_resamples.h"
#include "backend/study/methods/fit/profile_interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace teleta::cost {

namespace {

using study::LikelihoodSearch;
using study::SearchPoint;

constexpr std::array kLevels{0.02, 0.04, 0.06, 0.08, 0.12, 0.16};
constexpr std::int64_t kTrialsOfLevel = 20;
constexpr std::size_t kObservers = 200;

/// Answers to one of two intervals by an observer who lapses now and then.
struct Observed {
    std::vector<study::LevelCount> counts;
    study::PsychometricFunction truth;
};

study::FitModel model() {
    return {}; // Weibull, one of two, a free lapse rate
}

std::vector<Observed> observe() {
    core::RandomStream random(1, "psychometric fit ladder");
    std::vector<Observed> observers(kObservers);
    for (Observed& one : observers) {
        one.truth = {study::RiseShape::weibull, 0.045 * std::pow(2.0, random.uniform()),
                     2.0 + 2.0 * random.uniform(), 0.5, 0.02};
        for (const double level : kLevels) {
            study::LevelCount count{level, 0, kTrialsOfLevel};
            for (std::int64_t trial = 0; trial < kTrialsOfLevel; ++trial)
                count.correct += random.uniform() < one.truth.shareAt(level) ? 1 : 0;
            one.counts.push_back(count);
        }
    }
    return observers;
}

/// An interval of the logarithm of the threshold. An open end is as far as thresholds are searched, and so
/// are both ends of a fit that is refused.
struct LogInterval {
    double low = 0.0;
    double high = 0.0;
};

LogInterval closed(const LikelihoodSearch& search, const study::OpenInterval& interval) {
    return {interval.low.value_or(search.lowest()[SearchPoint::threshold]),
            interval.high.value_or(search.highest()[SearchPoint::threshold])};
}

/// 95 % by the expected information.
LogInterval normalInterval(const LikelihoodSearch& search, const SearchPoint& point) {
    const std::optional<double> error = search.errorOf(SearchPoint::threshold, point);
    if (!error)
        return closed(search, {});
    const double middle = point.at[SearchPoint::threshold];
    return {std::max(middle - core::kNormalQuantile95 * *error, search.lowest()[SearchPoint::threshold]),
            std::min(middle + core::kNormalQuantile95 * *error, search.highest()[SearchPoint::threshold])};
}

LogInterval resampledInterval(const LikelihoodSearch& search, const SearchPoint& best,
                              const std::vector<study::LevelCount>& counts, std::size_t resamples) {
    study::FitSettings settings;
    settings.model = model();
    settings.resamples = resamples;
    const study::OpenInterval threshold =
        study::bootstrapThreshold(counts, search.functionAt(best), settings).interval;
    study::OpenInterval logs;
    if (threshold.low)
        logs.low = search.parameterOf(*threshold.low);
    if (threshold.high)
        logs.high = search.parameterOf(*threshold.high);
    return closed(search, logs);
}

/// As of the ladder of statistics: Gneiting and Raftery 2007, doi:10.1198/016214506000001437, eq. (43).
double intervalScore(const LogInterval& interval, double truth) {
    constexpr double kPenalty = 2.0 / 0.05;
    return interval.high - interval.low +
           kPenalty * (std::max(0.0, interval.low - truth) + std::max(0.0, truth - interval.high));
}

Rung fitRung(std::string name, std::string parameter,
             const std::shared_ptr<const std::vector<Observed>>& observers,
             std::function<LogInterval(const LikelihoodSearch&, const Observed&)> intervalOf) {
    return {std::move(name), std::move(parameter), [=, intervalOf = std::move(intervalOf)](Trial& trial) {
                const Observed& one = (*observers)[trial.index() % observers->size()];
                LogInterval interval;
                trial.timed(1, [&] {
                    const LikelihoodSearch search(one.counts, model());
                    interval = intervalOf(search, one);
                });
                trial.error(intervalScore(interval, std::log(one.truth.threshold)));
            }};
}

} // namespace

Ladder psychometricFitLadder() {
    Ladder ladder;
    ladder.name = "psychometric-fit";
    ladder.topic = Topic::study;
    ladder.title = LadderText::tr("Interval of a threshold from a participant's answers").toStdString();
    ladder.truth =
        LadderText::tr(
            "score of the 95 % interval of the threshold's logarithm: its width, and 40 times how far the "
            "true one lies outside of it")
            .toStdString();
    ladder.errorUnit = "1";
    ladder.trials = kObservers;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        const auto observers = std::make_shared<const std::vector<Observed>>(observe());
        std::vector<Rung> rungs{
            fitRung("grid", "best point of the grid", observers,
                    [](const LikelihoodSearch& search, const Observed&) {
                        return normalInterval(search, search.bestOfGrid());
                    }),
            fitRung("one-start", "likelihood from one start", observers,
                    [](const LikelihoodSearch& search, const Observed&) {
                        return normalInterval(search, search.best(1));
                    }),
            fitRung("several-starts", "likelihood from 3 starts", observers,
                    [](const LikelihoodSearch& search, const Observed&) {
                        return normalInterval(search, search.best());
                    }),
            fitRung("profile", "profile of the likelihood", observers,
                    [](const LikelihoodSearch& search, const Observed&) {
                        return closed(search,
                                      study::profileInterval(search, SearchPoint::threshold, search.best()));
                    })};
        for (const std::size_t resamples : {200U, 2000U}) {
            const std::string count = std::to_string(resamples);
            rungs.push_back(fitRung("bootstrap-" + count, count + " resamples", observers,
                                    [resamples](const LikelihoodSearch& search, const Observed& one) {
                                        return resampledInterval(search, search.best(), one.counts,
                                                                 resamples);
                                    }));
        }
        constexpr std::size_t kCalls = 64;
        rungs.push_back(limitRung("likelihood of one function", kCalls, [observers](std::size_t index) {
            const Observed& one = (*observers)[index % observers->size()];
            return std::accumulate(
                one.counts.begin(), one.counts.end(), 0.0, [&](double sum, const study::LevelCount& count) {
                    const double share = one.truth.shareAt(count.level);
                    const auto right = static_cast<double>(count.correct);
                    const auto all = static_cast<double>(count.trials);
                    return sum + right * std::log(share) + (all - right) * std::log1p(-share);
                });
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
