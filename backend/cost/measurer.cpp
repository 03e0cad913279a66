// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/measurer.h"

#include "backend/core/elapsed.h"
#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/cost/frontier.h"

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

namespace teleta::cost {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

class SingleThreadedOpenCv {
public:
    SingleThreadedOpenCv()
        : m_before(cv::getNumThreads()) {
        cv::setNumThreads(1);
    }
    ~SingleThreadedOpenCv() { cv::setNumThreads(m_before); }
    SingleThreadedOpenCv(const SingleThreadedOpenCv&) = delete;
    SingleThreadedOpenCv& operator=(const SingleThreadedOpenCv&) = delete;

private:
    int m_before;
};

/// Time of a loop that always does the same, about 0.1 ms.
double calibrationLoop_s() {
    constexpr int kRounds = 50'000;
    std::uint64_t x = 88172645463325252ULL;
    const std::int64_t start_ns = core::steadyNow_ns();
    for (int i = 0; i < kRounds; ++i) {
        x ^= x << 13U;
        x ^= x >> 7U;
        x ^= x << 17U;
    }
    const std::int64_t end_ns = core::steadyNow_ns();
    // What nobody looks at is not computed.
    volatile std::uint64_t sink = x;
    static_cast<void>(sink);
    return core::elapsed_s(start_ns, end_ns);
}

double sortedMedian(std::vector<double>& values) {
    std::ranges::sort(values);
    return core::quantileOf(values, 0.5);
}

struct Times {
    std::vector<double> call_s;
    std::vector<double> loop_s;
    std::vector<double> takenAway;

    [[nodiscard]] double spread() {
        const double loop = sortedMedian(loop_s);
        const double quartiles = core::quantileOf(loop_s, 0.75) - core::quantileOf(loop_s, 0.25);
        return std::max(loop > 0.0 ? quartiles / loop : 0.0, sortedMedian(takenAway));
    }
};

/// Measures one rung once; empty when goOn ended it.
std::optional<RungCost> measureOnce(const Rung& rung, std::size_t trials,
                                    const std::function<bool(double share)>& goOn) {
    Times times;
    std::vector<double> errors;
    const auto all = static_cast<double>(kWarmUps + trials);
    for (std::size_t i = 0; i < kWarmUps; ++i) {
        if (!goOn(static_cast<double>(i) / all))
            return std::nullopt;
        Trial trial(i);
        rung.run(trial);
    }
    for (std::size_t i = 0; i < trials; ++i) {
        if (!goOn(static_cast<double>(kWarmUps + i) / all))
            return std::nullopt;
        times.loop_s.push_back(calibrationLoop_s());
        Trial trial(i);
        rung.run(trial);
        times.call_s.push_back(trial.time_s());
        times.takenAway.push_back(trial.takenAway());
        errors.insert(errors.end(), trial.errors().begin(), trial.errors().end());
    }
    RungCost cost{.name = rung.name,
                  .parameter = rung.parameter,
                  .errorMean = kUnknown,
                  .errorP95 = kUnknown,
                  .errorMax = kUnknown,
                  .timeMedian_s = sortedMedian(times.call_s),
                  .timeP99_s = core::quantileOf(times.call_s, 0.99),
                  .samples = trials,
                  .spread = times.spread()};
    if (!errors.empty() && std::ranges::none_of(errors, [](double e) { return std::isnan(e); })) {
        std::ranges::sort(errors);
        cost.errorMean =
            std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
        cost.errorP95 = core::quantileOf(errors, 0.95);
        cost.errorMax = errors.back();
    }
    return cost;
}

} // namespace

std::size_t Measurement::refused() const {
    std::size_t count = 0;
    for (const LadderCost& ladder : ladders)
        count += static_cast<std::size_t>(
            std::ranges::count_if(ladder.rungs, [](const RungCost& rung) { return !rung.isTimed(); }));
    return count;
}

core::Expected<Measurement> measureLadders(std::span<const Ladder> ladders, const MeasureSettings& settings) {
    const SingleThreadedOpenCv singleThreaded;
    const std::int64_t start_ns = core::steadyNow_ns();
    Measurement measurement;
    for (std::size_t l = 0; l < ladders.size() && !measurement.interrupted; ++l) {
        const Ladder& ladder = ladders[l];
        const auto goOn = [&](const std::string& rung, double shareOfLadder) {
            const double share =
                (static_cast<double>(l) + shareOfLadder) / static_cast<double>(ladders.size());
            return !settings.goOn || settings.goOn({ladder.name, rung, share});
        };
        if (!goOn({}, 0.0)) {
            measurement.interrupted = true;
            break;
        }
        const core::Expected<std::vector<Rung>> rungs = ladder.makeRungs();
        if (!rungs)
            return core::Unexpected(rungs.error());
        LadderCost cost{ladder.name, ladder.errorUnit, {}};
        for (std::size_t r = 0; r < rungs->size() && !measurement.interrupted; ++r) {
            const Rung& rung = (*rungs)[r];
            const auto goOnWith = [&](double shareOfRung) {
                return goOn(rung.name,
                            (static_cast<double>(r) + shareOfRung) / static_cast<double>(rungs->size()));
            };
            const std::size_t trials = std::max(ladder.trials, kFewestTrials);
            std::optional<RungCost> one;
            for (int attempt = 0; attempt < std::max(settings.attempts, 1); ++attempt) {
                one = measureOnce(rung, trials, goOnWith);
                if (!one || one->spread <= settings.largestSpread)
                    break;
            }
            if (!one) {
                measurement.interrupted = true;
                break;
            }
            if (!(one->spread <= settings.largestSpread))
                one->timeMedian_s = one->timeP99_s = kUnknown;
            cost.rungs.push_back(std::move(*one));
        }
        markFrontier(cost.rungs);
        if (!cost.rungs.empty())
            measurement.ladders.push_back(std::move(cost));
    }
    measurement.wall_s = core::elapsed_s(start_ns, core::steadyNow_ns());
    return measurement;
}

} // namespace teleta::cost
