// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/measurer.h"

#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/cost/frontier.h"
#include "backend/cost/one_opencv_thread.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace teleta::cost {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

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
};

/// A rung as it was measured, and how long the loop took meanwhile.
struct Measured {
    RungCost cost;
    double loop_s = 0.0; ///< median
};

/// How much slower than the quickest one.
double slowdown(double loop_s, double quickest_s) {
    return quickest_s > 0.0 ? loop_s / quickest_s - 1.0 : 0.0;
}

/// The loop's median on a processor that has woken up.
double wokenLoop_s() {
    constexpr int kRounds = 2000;
    constexpr int kLast = 100;
    std::vector<double> loop_s;
    for (int i = 0; i < kRounds; ++i) {
        const double time_s = calibrationLoop_s();
        if (i >= kRounds - kLast)
            loop_s.push_back(time_s);
    }
    return sortedMedian(loop_s);
}

/// Measures one rung once; empty when goOn ended it.
std::optional<Measured> measureOnce(const Rung& rung, std::size_t trials, double largestShare,
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
        errors.insert(errors.end(), trial.errors().begin(), trial.errors().end());
        Trial timed = std::move(trial);
        for (int repeat = 0; repeat < kMostRepeats && timed.takenAway() > largestShare; ++repeat) {
            Trial again(i);
            rung.run(again);
            if (again.takenAway() < timed.takenAway())
                timed = std::move(again);
        }
        times.call_s.push_back(timed.time_s());
        times.takenAway.push_back(timed.takenAway());
    }
    const bool isDisturbed =
        std::ranges::any_of(times.takenAway, [largestShare](double share) { return share > largestShare; });
    const double loop_s = sortedMedian(times.loop_s);
    const double quartiles_s = core::quantileOf(times.loop_s, 0.75) - core::quantileOf(times.loop_s, 0.25);
    RungCost cost{.name = rung.name,
                  .parameter = rung.parameter,
                  .errorMean = kUnknown,
                  .errorP95 = kUnknown,
                  .errorMax = kUnknown,
                  .timeMedian_s = sortedMedian(times.call_s),
                  .timeP99_s = isDisturbed ? kUnknown : core::quantileOf(times.call_s, 0.99),
                  .samples = trials,
                  .spread =
                      std::max(loop_s > 0.0 ? quartiles_s / loop_s : 0.0, sortedMedian(times.takenAway))};
    if (!errors.empty() && std::ranges::none_of(errors, [](double e) { return std::isnan(e); })) {
        std::ranges::sort(errors);
        cost.errorMean =
            std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
        cost.errorP95 = core::quantileOf(errors, 0.95);
        cost.errorMax = errors.back();
    }
    return Measured{std::move(cost), loop_s};
}

} // namespace

std::size_t Measurement::refused() const {
    std::size_t count = 0;
    for (const LadderCost& ladder : ladders)
        count += static_cast<std::size_t>(
            std::ranges::count_if(ladder.rungs, [](const RungCost& rung) { return !rung.isTimed(); }));
    return count;
}

void refuseSlowed(std::span<LadderCost> ladders, std::span<const double> loops_s, double largestSpread) {
    const auto quickest = std::ranges::min_element(loops_s);
    auto loop = loops_s.begin();
    for (LadderCost& ladder : ladders) {
        for (RungCost& rung : ladder.rungs) {
            const double slower = slowdown(*loop++, *quickest);
            rung.spread = std::max(rung.spread, slower);
            if (slower > largestSpread)
                rung.timeMedian_s = rung.timeP99_s = kUnknown;
        }
        markFrontier(ladder.rungs);
    }
}

core::Expected<Measurement> measureLadders(std::span<const Ladder> ladders, const MeasureSettings& settings) {
    const OneOpenCvThread singleThreaded;
    const std::int64_t start_ns = core::steadyNow_ns();
    Measurement measurement;
    double quickest_s = wokenLoop_s();
    std::vector<double> loops_s;
    bool isLastCut = false;
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
        TELETA_TRY(const std::vector<Rung> rungs, ladder.makeRungs());
        LadderCost cost{ladder.name, ladder.errorUnit, {}};
        for (std::size_t r = 0; r < rungs.size() && !measurement.interrupted; ++r) {
            const Rung& rung = rungs[r];
            const auto goOnWith = [&](double shareOfRung) {
                return goOn(rung.name,
                            (static_cast<double>(r) + shareOfRung) / static_cast<double>(rungs.size()));
            };
            const std::size_t trials = std::max(ladder.trials, kFewestTrials);
            std::optional<Measured> one;
            for (int attempt = 0; attempt < std::max(settings.attempts, 1); ++attempt) {
                one = measureOnce(rung, trials, settings.largestSpread, goOnWith);
                if (!one)
                    break;
                quickest_s = std::min(quickest_s, one->loop_s);
                one->cost.spread = std::max(one->cost.spread, slowdown(one->loop_s, quickest_s));
                if (one->cost.spread <= settings.largestSpread)
                    break;
            }
            if (!one) {
                measurement.interrupted = true;
                isLastCut = true;
                break;
            }
            if (!(one->cost.spread <= settings.largestSpread))
                one->cost.timeMedian_s = one->cost.timeP99_s = kUnknown;
            cost.rungs.push_back(std::move(one->cost));
            loops_s.push_back(one->loop_s);
        }
        if (!cost.rungs.empty())
            measurement.ladders.push_back(std::move(cost));
    }
    refuseSlowed(measurement.ladders, loops_s, settings.largestSpread);
    // What was not measured may beat what was.
    if (measurement.interrupted && !measurement.ladders.empty() && isLastCut)
        for (RungCost& rung : measurement.ladders.back().rungs)
            rung.pareto = false;
    measurement.wall_s = core::elapsed_s(start_ns, core::steadyNow_ns());
    return measurement;
}

} // namespace teleta::cost
