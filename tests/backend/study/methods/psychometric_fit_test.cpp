// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/fit/psychometric_fit.h"
#include "tests/backend/study/methods/fit_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace teleta::study {
namespace {

struct Expected {
    double threshold, spread, lapse, deviance, low, high;
};

/// Parameters to 1e-4 relative, deviance to 1e-6, as two other programs agree.
void expectFit(const PsychometricFit& fit, const Expected& expected) {
    ASSERT_TRUE(fit.threshold && fit.spread && fit.lapse && fit.deviance) << toString(fit.note);
    EXPECT_NEAR(*fit.threshold, expected.threshold, 1e-6 * expected.threshold);
    EXPECT_NEAR(*fit.spread, expected.spread, 1e-5 * expected.spread);
    EXPECT_NEAR(*fit.lapse, expected.lapse, 1e-6);
    EXPECT_NEAR(*fit.deviance, expected.deviance, 1e-6);
    ASSERT_TRUE(fit.thresholdInterval.low && fit.thresholdInterval.high);
    EXPECT_NEAR(*fit.thresholdInterval.low, expected.low, 1e-5 * expected.low);
    EXPECT_NEAR(*fit.thresholdInterval.high, expected.high, 1e-5 * expected.high);
}

PsychometricFit fitOf(const std::vector<int>& correct) {
    return fitPsychometric(countsOf(kSixLevels, correct, 40),
                           fitSettings(RiseShape::weibull, LevelScale::log10, 0.5, 0.0, 0.06));
}

void expectNoNumbers(const PsychometricFit& fit, FitNote note) {
    EXPECT_EQ(fit.note, note) << toString(fit.note);
    EXPECT_FALSE(fit.threshold);
    EXPECT_FALSE(fit.spread);
    EXPECT_FALSE(fit.deviance);
    EXPECT_FALSE(fit.thresholdInterval.low || fit.thresholdInterval.high);
}

} // namespace

// Python and R optim agree to these digits; psignifit 2.5.6 to its own tolerance.
TEST(PsychometricFit, isThatOfOtherPrograms) {
    const auto settings = [](RiseShape shape, double low, double high) {
        return fitSettings(shape, LevelScale::log10, 0.5, low, high);
    };
    expectFit(fitPsychometric(dataP1(), settings(RiseShape::weibull, 0.0, 0.06)),
              {.06182085, 1.991325, .018902, .0777117, .0448439, .0799457});
    expectFit(fitPsychometric(dataP1(), settings(RiseShape::weibull, 0.02, 0.02)),
              {.06172666, 2.006941, .02, .0788470, .0456969, .0777113});
    expectFit(fitPsychometric(dataP1(), settings(RiseShape::gauss, 0.0, 0.06)),
              {.06292438, .03559245, .023671, .0048472, .0458333, .0814772});
    expectFit(fitPsychometric(dataP1(), settings(RiseShape::logistic, 0.02, 0.02)),
              {.06326815, .02133562, .02, .0183402, .0477175, .0786466});
    expectFit(
        fitPsychometric(dataP3(), fitSettings(RiseShape::weibull, LevelScale::log10, 1.0 / 3.0, 0.0, 0.06)),
        {.1992582, 3.947937, .028087, .3083947, .1688016, .2259579});
}

// Without guesses and lapses these are the probit and the logit of R's glm.
TEST(PsychometricFit, isProbitAndLogitWithoutGuessesAndLapses) {
    expectFit(fitPsychometric(dataP2(), fitSettings(RiseShape::gauss, LevelScale::linear, 0.0, 0.0, 0.0)),
              {3.986224, 1.315745, 0.0, 1.700598, 3.605888, 4.368783});
    expectFit(fitPsychometric(dataP2(), fitSettings(RiseShape::logistic, LevelScale::linear, 0.0, 0.0, 0.0)),
              {4.000000, .7574235, 0.0, 2.475387, 3.609453, 4.390548});
}

TEST(PsychometricFit, tellsAMisfit) {
    FitSettings settings = fitSettings(RiseShape::weibull, LevelScale::log10, 0.5, 0.0, 0.06);
    settings.goodness = true;
    const PsychometricFit bad = fitPsychometric(dataP4(), settings);
    EXPECT_EQ(bad.note, FitNote::lapseAtLimit);
    expectFit(bad,
              {.0511947, .965494, .06, 15.63043, *bad.thresholdInterval.low, *bad.thresholdInterval.high});
    ASSERT_TRUE(bad.goodness);
    EXPECT_NEAR(bad.goodness->pDeviance, 0.004, 0.004);
    const PsychometricFit good = fitPsychometric(dataP1(), settings);
    EXPECT_EQ(good.note, FitNote::none);
    EXPECT_NEAR(good.goodness->pDeviance, 0.995, 0.01);
    EXPECT_GT(*good.goodness->pResidualByOrder, 0.05);
}

TEST(PsychometricFit, bootstrapIsNearTheProfile) {
    FitSettings settings = fitSettings(RiseShape::gauss, LevelScale::linear, 0.0, 0.0, 0.0);
    settings.interval = FitInterval::bootstrap;
    const PsychometricFit fit = fitPsychometric(dataP2(), settings);
    EXPECT_NEAR(*fit.thresholdInterval.low, 3.61, 0.03);
    EXPECT_NEAR(*fit.thresholdInterval.high, 4.37, 0.03);
    EXPECT_EQ(fit.refusedResamples, 0U);
    const PsychometricFit again = fitPsychometric(dataP2(), settings);
    EXPECT_EQ(*again.thresholdInterval.low, *fit.thresholdInterval.low) << "the same seed";
}

// Few trials near chance: many resamples have no threshold.
TEST(PsychometricFit, hasNoBootstrapIntervalWhereManyResamplesAreRefused) {
    FitSettings settings = fitSettings(RiseShape::weibull, LevelScale::log10, 0.5, 0.02, 0.02);
    settings.interval = FitInterval::bootstrap;
    settings.resamples = 200;
    const PsychometricFit fit = fitPsychometric(countsOf({.1, .2, .3, .4}, {10, 10, 14, 17}, 20), settings);
    ASSERT_TRUE(fit.threshold) << toString(fit.note);
    EXPECT_GT(fit.refusedResamples, 10U);
    EXPECT_FALSE(fit.thresholdInterval.low || fit.thresholdInterval.high);
}

TEST(PsychometricFit, saysWhyThereAreNoNumbers) {
    expectNoNumbers(fitOf({40, 40, 40, 40, 40, 40}), FitNote::belowRange);
    expectNoNumbers(fitOf({20, 21, 19, 20, 22, 18}), FitNote::aboveRange);
    expectNoNumbers(fitOf({30, 30, 30, 30, 30, 30}), FitNote::noRise);
    const PsychometricFit falling = fitOf({39, 38, 33, 29, 25, 22});
    expectNoNumbers(falling, FitNote::falls);
    EXPECT_NEAR(falling.trend, -5.792803, 2e-6);
    const PsychometricFit slight = fitOf({20, 21, 19, 22, 23, 26});
    expectNoNumbers(slight, FitNote::aboveRange);
    EXPECT_NEAR(slight.riseStatistic, 2.76, 0.005);
    const PsychometricFit beyond = fitOf({20, 21, 20, 22, 23, 28});
    expectNoNumbers(beyond, FitNote::aboveRange);
    EXPECT_NEAR(beyond.riseStatistic, 4.49, 0.005);
    expectNoNumbers(fitPsychometric({}, FitSettings{}), FitNote::noData);
    expectNoNumbers(fitPsychometric(countsOf({.1, .2}, {5, 9}, 10), FitSettings{}), FitNote::tooFewLevels);
    expectNoNumbers(fitPsychometric(countsOf({0.0}, {5}, 10), FitSettings{}), FitNote::levelsNotAbove0);
    expectNoNumbers(fitPsychometric(countsOf({.1}, {5}, 10), FitSettings{}), FitNote::tooFewLevels);
    FitSettings fixed;
    fixed.model.lapseHigh = 0.0;
    EXPECT_TRUE(fitPsychometric(countsOf({.1, .2}, {12, 18}, 20), fixed).threshold) << "one level less";
}

TEST(PsychometricFit, aStepHasAnIntervalAndNoSlope) {
    const PsychometricFit fit = fitOf({20, 20, 20, 40, 40, 40});
    EXPECT_EQ(fit.note, FitNote::slopeAtLimit);
    EXPECT_FALSE(fit.spread);
    ASSERT_TRUE(fit.thresholdInterval.low && fit.thresholdInterval.high && fit.threshold);
    EXPECT_GE(*fit.thresholdInterval.low, .060);
    EXPECT_LE(*fit.thresholdInterval.high, .080);
    EXPECT_NEAR(*fit.threshold, std::sqrt(*fit.thresholdInterval.low * *fit.thresholdInterval.high), 1e-12)
        << "the middle on the logarithmic scale";
}

// Five of ten are chance; the step to the highest level may as well lie above it.
TEST(PsychometricFit, aStepWhoseMiddleIsOutsideOfTheLevelsIsABound) {
    FitSettings settings = fitSettings(RiseShape::weibull, LevelScale::log10, 0.5, 0.02, 0.02);
    expectNoNumbers(fitPsychometric(countsOf({.1, .2, .3, .4}, {5, 5, 5, 9}, 10), settings),
                    FitNote::aboveRange);
}

TEST(PsychometricFit, ofAComparisonGivesTheJustNoticeableDifference) {
    const auto counts = countsOf({.2, .3, .4, .5, .6, .7, .8}, {0, 2, 5, 9, 15, 19, 20}, 20);
    const PsychometricFit fit =
        fitPsychometric(counts, fitSettings(RiseShape::gauss, LevelScale::linear, std::nullopt, 0.0, 0.0));
    EXPECT_NEAR(*fit.threshold, .4986224, 1e-6);
    EXPECT_NEAR(*fit.justNoticeable(RiseShape::gauss), .0887456, 1e-6);
    EXPECT_NEAR(*fit.justNoticeable(RiseShape::gauss) / 0.5, .1774913, 1e-6);
    EXPECT_NEAR(*fit.threshold - 0.5, -.0013776, 1e-6);
    // ln 3 of a logistic curve.
    const PsychometricFit logistic =
        fitPsychometric(counts, fitSettings(RiseShape::logistic, LevelScale::linear, std::nullopt, 0.0, 0.0));
    EXPECT_NEAR(*logistic.justNoticeable(RiseShape::logistic), std::log(3.0) * *logistic.spread, 1e-9);
}

TEST(PsychometricFit, ofAComparisonHasTheSameRateOfMistakesAtBothEnds) {
    const auto counts = countsOf({.2, .3, .4, .5, .6, .7, .8}, {2, 2, 5, 20, 35, 38, 38}, 40);
    const PsychometricFit fit =
        fitPsychometric(counts, fitSettings(RiseShape::gauss, LevelScale::linear, std::nullopt, 0.0, 0.06));
    ASSERT_TRUE(fit.guess && fit.lapse);
    EXPECT_EQ(*fit.guess, *fit.lapse);
    EXPECT_NEAR(*fit.lapse, 0.05, 0.01) << "two of forty at either end";
}

TEST(LevelCounts, groupTrialsByLevel) {
    const std::vector<KeptTrial> trials{{.2, 0, true}, {.1, 0, false},        {.2 * (1 + 1e-12), 0, false},
                                        {.1, 0, true}, {0.0, 0, true, false}, {.4, 0, true}};
    const auto counts = levelCounts(trials);
    ASSERT_EQ(counts.size(), 3U);
    EXPECT_EQ(counts[0].level, .1);
    EXPECT_EQ(counts[0].correct, 1);
    EXPECT_EQ(counts[0].trials, 2);
    EXPECT_EQ(counts[1].trials, 2);
    EXPECT_EQ(counts[2].correct, 1);
    EXPECT_EQ(loglinearRate(0, 20), 0.5 / 21.0);
}

} // namespace teleta::study
