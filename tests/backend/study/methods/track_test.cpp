// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/track.h"
#include "tests/backend/study/methods/tracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace teleta::study {
namespace {

constexpr LevelRange kDrive{LevelScale::log10, 0.01, 1.0};

BayesSettings quest() {
    BayesSettings settings;
    settings.mostTrials = 25;
    return settings;
}

std::vector<Procedure> allProcedures() {
    return {ConstantSettings{{0.1, 0.2, 0.4}, 8}, StaircaseSettings{}, quest()};
}

const std::string kAnswers = "110111011101111101110111110110111";

} // namespace

// An interrupted track is asked again with the trials that were kept: nothing else is remembered.
TEST(Track, goesOnAfterAnyTrialAsIfItHadNotStopped) {
    for (const Procedure& procedure : allProcedures()) {
        const std::vector<KeptTrial> kept = answeredTrials(procedure, kDrive, kAnswers);
        EXPECT_GE(kept.size(), 20U) << nameOf(procedure);
        EXPECT_EQ(firstForeignTrial(procedure, kDrive, 1, kept), std::nullopt) << nameOf(procedure);
        const std::vector<KeptTrial> half(kept.begin(), kept.begin() + 11);
        const TrackStep step = nextStep(procedure, kDrive, 1, half);
        EXPECT_EQ(std::get<NextLevel>(step).level, kept[11].level) << nameOf(procedure);
    }
}

TEST(Track, findsATrialThatDoesNotFit) {
    for (const Procedure& procedure : allProcedures()) {
        std::vector<KeptTrial> kept = answeredTrials(procedure, kDrive, kAnswers);
        kept[7].level *= 1.001;
        EXPECT_EQ(firstForeignTrial(procedure, kDrive, 1, kept), 7U) << nameOf(procedure);
        kept[7].counts = false;
        EXPECT_NE(firstForeignTrial(procedure, kDrive, 1, kept), 7U) << nameOf(procedure);
    }
}

TEST(Track, findsATrialAfterTheEnd) {
    const Procedure procedure = ConstantSettings{{0.1, 0.2}, 3};
    std::vector<KeptTrial> kept = answeredTrials(procedure, kDrive, "111111");
    ASSERT_EQ(kept.size(), 6U);
    kept.push_back(kept.front());
    EXPECT_EQ(firstForeignTrial(procedure, kDrive, 1, kept), 6U);
}

TEST(Track, showsConstantLevelsEquallyOftenAndInAnotherOrderWithAnotherSeed) {
    const Procedure procedure = ConstantSettings{{0.1, 0.2, 0.4, 0.8}, 10};
    std::vector<std::vector<double>> orders;
    for (const std::uint64_t seed : {1U, 2U}) {
        std::vector<KeptTrial> kept;
        std::vector<double> order;
        for (;;) {
            const TrackStep step = nextStep(procedure, kDrive, seed, kept);
            const auto* next = std::get_if<NextLevel>(&step);
            if (next == nullptr) {
                EXPECT_EQ(std::get<TrackEnd>(step).reason, EndReason::allShown);
                break;
            }
            kept.push_back({next->level, 0, true});
            order.push_back(next->level);
        }
        ASSERT_EQ(order.size(), 40U);
        for (const double level : {0.1, 0.2, 0.4, 0.8})
            EXPECT_EQ(std::ranges::count(order, level), 10);
        orders.push_back(order);
    }
    EXPECT_NE(orders[0], orders[1]);
}

TEST(Track, blocksConstantLevels) {
    ConstantSettings settings{{0.1, 0.2, 0.4, 0.8}, 6, true};
    const std::vector<KeptTrial> kept = answeredTrials(settings, kDrive, std::string(24, '1'));
    ASSERT_EQ(kept.size(), 24U);
    for (std::size_t block = 0; block < 24; block += 4) {
        double sum = 0.0;
        for (std::size_t i = block; i < block + 4; ++i)
            sum += kept[i].level;
        EXPECT_NEAR(sum, 1.5, 1e-12) << block;
    }
}

TEST(Track, refusesSettingsThatShowNothing) {
    const auto fault = [](const Procedure& procedure, const LevelRange& range) {
        EXPECT_EQ(std::get<TrackEnd>(nextStep(procedure, range, 1, {})).reason, EndReason::badSettings);
        return std::string(settingsFault(procedure, range));
    };
    EXPECT_EQ(fault(StaircaseSettings{}, {LevelScale::log10, 0.0, 1.0}), "lowest: above 0 on a log10 scale");
    EXPECT_EQ(fault(StaircaseSettings{}, {LevelScale::linear, 1.0, 1.0}), "lowest: below highest");
    EXPECT_EQ(fault(ConstantSettings{}, kDrive), "values: 1 to 15 levels");
    EXPECT_EQ(fault(ConstantSettings{{0.2, 0.2}}, kDrive), "values: rising");
    EXPECT_EQ(fault(ConstantSettings{{0.001, 0.2}}, kDrive), "values: from lowest to highest");
    StaircaseSettings staircase;
    staircase.down = 0;
    EXPECT_EQ(fault(staircase, kDrive), "down: 1 to 8");
    staircase = {};
    staircase.stepUp = std::nan("");
    EXPECT_EQ(fault(staircase, kDrive), "step_up: above 0");
    staircase = {};
    staircase.reversals = 5;
    EXPECT_EQ(fault(staircase, kDrive), "reversals: at least skip_reversals + 2");
    BayesSettings bayes;
    bayes.slope = {};
    EXPECT_EQ(fault(bayes, kDrive), "slope: at least one value above 0");
    bayes = {};
    bayes.priorMean = -1.0;
    EXPECT_EQ(fault(bayes, kDrive), "prior_mean, prior_sd: both or neither");
    EXPECT_EQ(fault(BayesSettings{}, {LevelScale::linear, 0.0, 1.0}),
              "function: weibull needs levels above 0");
    for (const Procedure& procedure : allProcedures())
        EXPECT_STREQ(settingsFault(procedure, kDrive), "") << nameOf(procedure);
}

TEST(Track, wordsAreThoseOfFiles) {
    EXPECT_STREQ(toString(EndReason::precision), "precision");
    EXPECT_STREQ(toString(TrackNote::none), "");
    EXPECT_STREQ(toString(TrackNote::aboveRange), "aboveRange");
    EXPECT_EQ(levelScaleOf("log10"), LevelScale::log10);
    EXPECT_EQ(levelScaleOf("log"), std::nullopt);
    EXPECT_EQ(riseShapeOf("weibull"), RiseShape::weibull);
}

} // namespace teleta::study
