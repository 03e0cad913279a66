// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/felt_threshold.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace teleta::motors;

namespace {

/// A person with a known threshold answers until the staircase is done.
FeltTrials answered(double threshold, double spread, std::uint64_t seed, const StaircaseRules& rules = {}) {
    FeltTrials trials(rules);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    while (!trials.done()) {
        const double yes =
            trials.isCatch() ? 0.02 : 0.02 + 0.96 / (1.0 + std::exp(-(trials.drive() - threshold) / spread));
        trials.answer(uniform(random) < yes);
    }
    return trials;
}

std::string refusal(const std::vector<FeltTrial>& trials) {
    const auto result = estimateThreshold(trials);
    return result ? std::string() : teleta::core::describe(result.error());
}

} // namespace

TEST(FeltTrials, goDownAfterYesUpAfterNoAndHalveTheStepAtEachReversal) {
    FeltTrials trials({.first = 0.5, .firstStep = 0.2, .smallestStep = 0.05, .catchEvery = 0});
    EXPECT_DOUBLE_EQ(trials.drive(), 0.5);
    trials.answer(true);
    EXPECT_DOUBLE_EQ(trials.drive(), 0.3);
    trials.answer(false);
    EXPECT_DOUBLE_EQ(trials.drive(), 0.4);
    trials.answer(true);
    EXPECT_DOUBLE_EQ(trials.drive(), 0.35);
    trials.answer(false);
    EXPECT_DOUBLE_EQ(trials.drive(), 0.4) << "not below the smallest step";
    EXPECT_EQ(trials.reversals(), 3);
}

TEST(FeltTrials, takeAnAnswerBack) {
    FeltTrials trials({.first = 0.5, .firstStep = 0.2, .catchEvery = 0});
    EXPECT_FALSE(trials.undo());
    trials.answer(true);
    trials.answer(false);
    ASSERT_TRUE(trials.undo());
    EXPECT_DOUBLE_EQ(trials.drive(), 0.3);
    EXPECT_EQ(trials.reversals(), 0);
    ASSERT_TRUE(trials.undo());
    EXPECT_DOUBLE_EQ(trials.drive(), 0.5);
    EXPECT_FALSE(trials.undo());
}

TEST(FeltTrials, presentNothingNowAndThenAndEnd) {
    FeltTrials trials;
    int catches = 0;
    int presentations = 0;
    while (!trials.done() && presentations < 1000) {
        if (trials.isCatch()) {
            ++catches;
            EXPECT_EQ(trials.drive(), 0.0);
        }
        trials.answer(false);
        ++presentations;
    }
    EXPECT_TRUE(trials.done());
    EXPECT_LE(presentations, 71);
    EXPECT_GE(catches, 8);
    const std::size_t before = trials.trials().size();
    trials.answer(true);
    EXPECT_EQ(trials.trials().size(), before);
}

TEST(FeltThreshold, coversTheTruthAsOftenAsItSays) {
    int covered = 0;
    int estimated = 0;
    double worst = 0.0;
    constexpr int kPersons = 100;
    for (int k = 0; k < kPersons; ++k) {
        const double threshold = 0.1 + 0.006 * k;
        const auto result = estimateThreshold(
            answered(threshold, 0.01 + 0.0002 * k, 100U + static_cast<unsigned>(k)).trials());
        if (!result)
            continue;
        ++estimated;
        covered += result->lower <= threshold && threshold <= result->upper ? 1 : 0;
        worst = std::max(worst, std::abs(result->drive - threshold));
    }
    EXPECT_GE(estimated, 95);
    // 95 % with a standard deviation of 2.2.
    EXPECT_GE(covered, 88 * estimated / 100);
    EXPECT_LT(worst, 0.15);
}

TEST(FeltThreshold, ofASurePersonIsTheDriveBetweenNoAndYes) {
    FeltTrials trials;
    while (!trials.done())
        trials.answer(!trials.isCatch() && trials.drive() >= 0.237);
    const auto result = estimateThreshold(trials.trials());
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->drive, 0.237, 0.02);
    EXPECT_LE(result->lower, 0.237);
    EXPECT_GE(result->upper, 0.237);
    EXPECT_LT(result->upper - result->lower, 0.1);
}

TEST(FeltThreshold, refusesAnswersThatCannotBeTrue) {
    std::vector<FeltTrial> trials;
    EXPECT_NE(refusal(trials).find("too few"), std::string::npos);
    for (int i = 0; i < 12; ++i)
        trials.push_back({0.05 * i, false, false});
    EXPECT_NE(refusal(trials).find("Nothing was felt"), std::string::npos);
    for (FeltTrial& trial : trials)
        trial.yes = true;
    EXPECT_NE(refusal(trials).find("Everything was felt"), std::string::npos);
    // A weak drive is felt, a strong one is not.
    for (FeltTrial& trial : trials)
        trial.yes = trial.drive < 0.3;
    EXPECT_NE(refusal(trials).find("contradict"), std::string::npos) << refusal(trials);
    // Something was felt although nothing was presented.
    for (FeltTrial& trial : trials)
        trial.yes = trial.drive > 0.3;
    trials.push_back({0.0, true, true});
    trials.push_back({0.0, true, true});
    trials.push_back({0.0, false, true});
    EXPECT_NE(refusal(trials).find("nothing was presented"), std::string::npos);
    trials.back().yes = false;
    trials[trials.size() - 2].yes = false;
    EXPECT_EQ(refusal(trials), "") << "one slip is human";
}
