// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/bracelet/best_onset.h"
#include "backend/study/methods/bracelet/intensity_steps.h"

#include <gtest/gtest.h>

#include <vector>

namespace teleta::study {

namespace {

std::vector<OnsetCount> counts(const std::vector<double>& yes) {
    const std::vector<double> onsets_s{0.02, 0.05, 0.08, 0.11, 0.14, 0.2};
    std::vector<OnsetCount> all;
    for (std::size_t i = 0; i < yes.size(); ++i)
        all.push_back({onsets_s[i], 24.0, yes[i]});
    return all;
}

} // namespace

// R 4.2.2: glm(cbind(yes, 24 - yes) ~ onset + I(onset^2), family = binomial("probit")).
TEST(BestOnset, isThatOfR) {
    const BestOnset best = bestOnset(counts({3, 9, 17, 20, 15, 6}));
    EXPECT_EQ(best.doubt, OnsetDoubt::none);
    EXPECT_NEAR(best.onset_s, 0.1160469, 1e-6);
    EXPECT_NEAR(best.se_s, 0.004939937, 1e-7);
    EXPECT_NEAR(best.deviance, 2.350806, 1e-5);
    EXPECT_NEAR(best.high_s - best.low_s, 2.0 * 1.959964 * best.se_s, 1e-8);
}

TEST(BestOnset, isRefusedWithoutATopAmongTheTimes) {
    EXPECT_EQ(bestOnset(counts({20, 15, 9, 6, 10, 22})).doubt, OnsetDoubt::noTop);
    EXPECT_EQ(bestOnset(counts({1, 3, 6, 10, 13, 20})).doubt, OnsetDoubt::outside);
    EXPECT_EQ(bestOnset(counts({3, 9})).doubt, OnsetDoubt::tooFewTimes);
    EXPECT_EQ(bestOnset({}).doubt, OnsetDoubt::tooFewTimes);
    EXPECT_NE(bestOnset(counts({0, 0, 0, 0, 0, 0})).doubt, OnsetDoubt::none);
    EXPECT_NE(bestOnset(counts({24, 24, 24, 24, 24, 24})).doubt, OnsetDoubt::none);
}

TEST(IntensitySteps, areCountedFromOneToTheNext) {
    const std::vector<JndAt> same{{0.5, 0.1}};
    const auto even = intensitySteps(same, 0.0, 1.0);
    ASSERT_TRUE(even);
    EXPECT_EQ(even->size(), 11U);
    // JND = x: each level is twice the one before.
    const std::vector<JndAt> weber{{0.1, 0.1}, {1.0, 1.0}};
    const auto doubled = intensitySteps(weber, 0.1, 1.0);
    ASSERT_EQ(doubled->size(), 4U);
    EXPECT_NEAR((*doubled)[3], 0.8, 1e-12);
    // Below and above the measured levels the JND stays.
    const auto held = intensitySteps(std::vector<JndAt>{{0.3, 0.2}, {0.5, 0.1}}, 0.1, 0.8);
    ASSERT_EQ(held->size(), 6U);
    EXPECT_NEAR((*held)[1], 0.3, 1e-12);
    EXPECT_NEAR((*held)[2], 0.5, 1e-12);
    EXPECT_NEAR((*held)[5], 0.8, 1e-12);
}

TEST(IntensitySteps, areNoneWithoutAMeasuredDifference) {
    EXPECT_FALSE(intensitySteps({}, 0.0, 1.0));
    EXPECT_FALSE(intensitySteps(std::vector<JndAt>{{0.5, 0.0}}, 0.0, 1.0));
    EXPECT_FALSE(intensitySteps(std::vector<JndAt>{{0.5, 0.1}}, 1.0, 0.0));
    EXPECT_EQ(intensitySteps(std::vector<JndAt>{{0.5, 2.0}}, 0.0, 1.0)->size(), 1U);
}

} // namespace teleta::study
