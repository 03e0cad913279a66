// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/steady_time.h"
#include "backend/cost/frontier.h"
#include "backend/cost/measurer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <thread>
#include <vector>

using namespace teleta;
using namespace teleta::cost;

namespace {

/// A rung whose errors are 1, 2, .. with the trial, and which keeps the trials that it was asked for.
Rung countingRung(const char* name, std::vector<std::size_t>& asked) {
    return {name, "some parameter", [&asked](Trial& trial) {
                asked.push_back(trial.index());
                std::vector<double> numbers(20'000);
                trial.timed(1, [&] { std::iota(numbers.begin(), numbers.end(), 0.0); });
                trial.error(static_cast<double>(trial.index() + 1) + 0.0 * numbers.back());
            }};
}

Ladder ladderOf(const std::string& name, std::vector<Rung> rungs, std::size_t trials = 30) {
    Ladder ladder;
    ladder.name = name;
    ladder.errorUnit = std::string("m");
    ladder.trials = trials;
    ladder.makeRungs = [rungs]() -> core::Expected<std::vector<Rung>> { return rungs; };
    return ladder;
}

/// However busy this machine is.
MeasureSettings patient() {
    MeasureSettings settings;
    settings.largestSpread = std::numeric_limits<double>::infinity();
    return settings;
}

} // namespace

TEST(Measurer, warmsUpAndThenTimesEveryTrialOnce) {
    std::vector<std::size_t> asked;
    const std::array ladders{ladderOf("one", {countingRung("a", asked)}, 40)};
    const auto measured = measureLadders(ladders, patient());
    ASSERT_TRUE(measured);
    ASSERT_EQ(asked.size(), kWarmUps + 40);
    for (std::size_t i = 0; i < 40; ++i)
        EXPECT_EQ(asked[kWarmUps + i], i);
    const RungCost& rung = measured->ladders.at(0).rungs.at(0);
    EXPECT_EQ(rung.samples, 40U);
    EXPECT_GT(rung.timeMedian_s, 0.0);
    EXPECT_GE(rung.timeP99_s, rung.timeMedian_s);
    EXPECT_TRUE(rung.pareto);
    EXPECT_FALSE(measured->interrupted);
    EXPECT_EQ(measured->refused(), 0U);
}

TEST(Measurer, neverTimesFewerThanThirtyTrials) {
    std::vector<std::size_t> asked;
    const std::array ladders{ladderOf("one", {countingRung("a", asked)}, 2)};
    EXPECT_EQ(measureLadders(ladders, patient())->ladders[0].rungs[0].samples, 30U);
}

// Errors 1..41: mean 21; the 95 % quantile of type 7 is at 1 + 0.95 * 40 = 39.
TEST(Measurer, tellsMeanQuantileAndWorstOfTheErrorsWithoutThoseOfTheWarmUp) {
    std::vector<std::size_t> asked;
    const std::array ladders{ladderOf("one", {countingRung("a", asked)}, 41)};
    const RungCost rung = measureLadders(ladders, patient())->ladders[0].rungs[0];
    EXPECT_DOUBLE_EQ(rung.errorMean, 21.0);
    EXPECT_DOUBLE_EQ(rung.errorP95, 39.0);
    EXPECT_DOUBLE_EQ(rung.errorMax, 41.0);
}

TEST(Measurer, aRungOfWhichOneErrorIsUnknownHasNone) {
    const Rung rung{"a", "", [](Trial& trial) {
                        trial.timed(1, [] {});
                        trial.error(trial.index() == 7 ? std::nan("") : 1.0);
                    }};
    const std::array ladders{ladderOf("one", {rung})};
    const RungCost cost = measureLadders(ladders, patient())->ladders[0].rungs[0];
    EXPECT_TRUE(std::isnan(cost.errorMean) && std::isnan(cost.errorP95) && std::isnan(cost.errorMax));
    EXPECT_FALSE(cost.pareto);
}

TEST(Measurer, refusesTimesThatNoMachineIsQuietEnoughForAndSaysHowNoisyItWas) {
    std::vector<std::size_t> asked;
    const std::array ladders{ladderOf("one", {countingRung("a", asked)})};
    MeasureSettings settings;
    settings.largestSpread = -1.0;
    settings.attempts = 2;
    const auto measured = measureLadders(ladders, settings);
    const RungCost& rung = measured->ladders[0].rungs[0];
    EXPECT_EQ(asked.size(), 2 * (kWarmUps + 30 * (1 + kMostRepeats))) << "as often as there are attempts";
    EXPECT_FALSE(rung.isTimed());
    EXPECT_TRUE(std::isnan(rung.timeP99_s));
    EXPECT_DOUBLE_EQ(rung.errorMean, 15.5) << "errors do not depend on the machine";
    EXPECT_GE(rung.spread, 0.0);
    EXPECT_FALSE(rung.pareto);
    EXPECT_EQ(measured->refused(), 1U);
}

TEST(Measurer, sharesTheTimeOfATrialBetweenItsCallsAndTellsWhatOthersTook) {
    static constexpr double kSleep_s = 0.02;
    Trial trial(0);
    const std::int64_t before_ns = core::steadyNow_ns();
    trial.timed(10, [] { std::this_thread::sleep_for(std::chrono::duration<double>(kSleep_s)); });
    const double around_s = core::elapsed_s(before_ns, core::steadyNow_ns());
    EXPECT_GE(10.0 * trial.time_s(), kSleep_s);
    EXPECT_LE(10.0 * trial.time_s(), around_s);
    EXPECT_GT(trial.takenAway(), 0.5) << "who sleeps has no processor";
}

TEST(Measurer, timesADisturbedTrialAgainAndKeepsTheErrorsOfTheFirstTime) {
    std::vector<std::size_t> asked;
    const Rung rung{"a", "", [&asked](Trial& trial) {
                        const bool again = std::ranges::count(asked, trial.index()) > 0;
                        asked.push_back(trial.index());
                        trial.timed(1, [&] {
                            if (trial.index() == 7 && !again)
                                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                        });
                        trial.error(trial.index() == 7 && again ? 100.0 : 1.0);
                    }};
    const std::array ladders{ladderOf("one", {rung})};
    MeasureSettings settings;
    settings.attempts = 1;
    const RungCost cost = measureLadders(ladders, settings)->ladders[0].rungs[0];
    EXPECT_GE(std::ranges::count(asked, 7U), 2);
    EXPECT_DOUBLE_EQ(cost.errorMax, 1.0);
}

TEST(Measurer, doesNotKnowTheRareLongCallsWhereOneTrialStaysDisturbed) {
    const Rung rung{"a", "", [](Trial& trial) {
                        trial.timed(1, [&] {
                            if (trial.index() == 7)
                                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                        });
                        trial.error(1.0);
                    }};
    const std::array ladders{ladderOf("one", {rung})};
    const RungCost cost = measureLadders(ladders)->ladders[0].rungs[0];
    EXPECT_TRUE(std::isnan(cost.timeP99_s));
    EXPECT_EQ(bestWithin(std::span(&cost, 1), 10.0), nullptr);
}

TEST(Measurer, refusesTimesThatWereTakenWhileTheMachineWasSlowerThanForOthers) {
    const auto rung = [](const char* name, double time_s) {
        return RungCost{.name = name,
                        .parameter = {},
                        .errorMean = 1.0,
                        .timeMedian_s = time_s,
                        .timeP99_s = time_s,
                        .spread = 0.1,
                        .pareto = true};
    };
    std::array ladders{LadderCost{"one", "m", {rung("a", 1.0), rung("b", 0.5)}},
                       LadderCost{"two", "m", {rung("c", 1.0)}}};
    constexpr std::array kLoops_s{1.2e-4, 1.5e-4, 1.0e-4};
    refuseSlowed(ladders, kLoops_s, 0.25);
    EXPECT_TRUE(ladders[0].rungs[0].isTimed());
    EXPECT_NEAR(ladders[0].rungs[0].spread, 0.2, 1e-12);
    EXPECT_FALSE(ladders[0].rungs[1].isTimed());
    EXPECT_NEAR(ladders[0].rungs[1].spread, 0.5, 1e-12);
    EXPECT_TRUE(ladders[0].rungs[0].pareto) << "what has no time beats nothing";
    EXPECT_FALSE(ladders[0].rungs[1].pareto);
    EXPECT_TRUE(ladders[1].rungs[0].isTimed());
    EXPECT_NEAR(ladders[1].rungs[0].spread, 0.1, 1e-12);
}

TEST(Measurer, keepsWhatItHasWhenItIsEndedAndReportsProgressThatNeverFalls) {
    std::vector<std::size_t> first, second, third;
    const std::array ladders{ladderOf("one", {countingRung("a", first), countingRung("b", second)}),
                             ladderOf("two", {countingRung("c", third)})};
    MeasureSettings settings = patient();
    double last = 0.0;
    settings.goOn = [&](const MeasureProgress& progress) {
        EXPECT_GE(progress.share, last);
        EXPECT_LE(progress.share, 1.0);
        last = progress.share;
        return second.size() < 10;
    };
    const auto measured = measureLadders(ladders, settings);
    ASSERT_TRUE(measured);
    EXPECT_TRUE(measured->interrupted);
    ASSERT_EQ(measured->ladders.size(), 1U);
    ASSERT_EQ(measured->ladders[0].rungs.size(), 1U);
    EXPECT_EQ(measured->ladders[0].rungs[0].name, "a");
    EXPECT_FALSE(measured->ladders[0].rungs[0].pareto) << "what was not measured may beat it";
    EXPECT_TRUE(third.empty());
}

TEST(Measurer, handsOnWhyALadderCannotBeMade) {
    Ladder broken = ladderOf("broken", {});
    broken.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        return core::Unexpected(core::Error{core::ErrorKind::refused, "no camera", {}, {}});
    };
    const std::array ladders{broken};
    const auto measured = measureLadders(ladders);
    ASSERT_FALSE(measured);
    EXPECT_EQ(measured.error().message, "no camera");
}
