// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/bayes_grid.h"
#include "backend/study/methods/detection/signal_detection.h"
#include "tests/backend/study/methods/fit_data.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::study {
namespace {

std::vector<LevelCount> scaled(std::vector<LevelCount> counts, double factor, std::int64_t times = 1) {
    for (LevelCount& count : counts) {
        count.level *= factor;
        count.correct *= times;
        count.trials *= times;
    }
    return counts;
}

const FitSettings kWeibull = fitSettings(RiseShape::weibull, LevelScale::log10, 0.5, 0.0, 0.06);

} // namespace

TEST(FitStability, thresholdsFollowTheUnitOfTheLevel) {
    const PsychometricFit plain = fitPsychometric(dataP1(), kWeibull);
    for (const double factor : {1e-9, 1e-3, 7.0, 1e6}) {
        const PsychometricFit fit = fitPsychometric(scaled(dataP1(), factor), kWeibull);
        ASSERT_TRUE(fit.threshold && fit.thresholdInterval.low) << factor;
        EXPECT_NEAR(*fit.threshold, *plain.threshold * factor, 1e-6 * *plain.threshold * factor);
        EXPECT_NEAR(*fit.spread, *plain.spread, 1e-5 * *plain.spread);
        EXPECT_NEAR(*fit.thresholdInterval.low, *plain.thresholdInterval.low * factor,
                    1e-6 * *plain.thresholdInterval.low * factor);
    }
}

TEST(FitStability, equalLevelsOfAComparisonFollowAnOffset) {
    const FitSettings gauss = fitSettings(RiseShape::gauss, LevelScale::linear, std::nullopt, 0.0, 0.06);
    const auto levels = [](double offset) {
        return countsOf(
            {.2 + offset, .3 + offset, .4 + offset, .5 + offset, .6 + offset, .7 + offset, .8 + offset},
            {1, 2, 5, 9, 15, 18, 19}, 20);
    };
    const PsychometricFit plain = fitPsychometric(levels(0.0), gauss);
    for (const double offset : {-1.0, 3.0, 1000.0}) {
        const PsychometricFit fit = fitPsychometric(levels(offset), gauss);
        EXPECT_NEAR(*fit.threshold, *plain.threshold + offset, 1e-6);
        EXPECT_NEAR(*fit.spread, *plain.spread, 1e-5 * *plain.spread);
    }
}

// A hundred thousand times the trials: the same maximum, an interval narrower by the root.
TEST(FitStability, manyTrialsNarrowTheInterval) {
    const FitSettings fixed = fitSettings(RiseShape::weibull, LevelScale::log10, 0.5, 0.02, 0.02);
    const PsychometricFit few = fitPsychometric(dataP1(), fixed);
    const PsychometricFit many = fitPsychometric(scaled(dataP1(), 1.0, 100'000), fixed);
    EXPECT_NEAR(*many.threshold, *few.threshold, 1e-6);
    const double width = *many.thresholdInterval.high - *many.thresholdInterval.low;
    const double wide = *few.thresholdInterval.high - *few.thresholdInterval.low;
    EXPECT_NEAR(width, wide / std::sqrt(1e5), 0.05 * wide / std::sqrt(1e5));
}

// The likelihood at the maximum is not below that of a fine grid over all parameters.
TEST(FitStability, theMaximumIsThatOfAFineGrid) {
    for (const auto& data :
         {dataP1(), dataP3(), dataP4(), countsOf(kSixLevels, {19, 35, 22, 39, 38, 40}, 40),
          countsOf({.1, .2, .3}, {1, 0, 1}, 1), countsOf({.01, .011, .9}, {5, 6, 10}, 10)}) {
        const LikelihoodSearch search(data, kWeibull.model);
        const double found = search.best().logLikelihood;
        double grid = -1e300;
        for (int i = 0; i <= 150; ++i) {
            for (int j = 0; j <= 60; ++j) {
                for (const double lapse : {0.0, 0.02, 0.04, 0.06}) {
                    const auto at = [&](std::size_t p, double share) {
                        return std::lerp(search.lowest()[p], search.highest()[p], share);
                    };
                    const PsychometricFunction curve = LikelihoodSearch::functionOf(
                        kWeibull.model, {at(0, i / 150.0), at(1, j / 60.0), lapse});
                    double sum = 0.0;
                    for (const LevelCount& count : data) {
                        const double share =
                            std::min(std::max(curve.shareAt(count.level), 1e-12), 1.0 - 1e-12);
                        sum += static_cast<double>(count.correct) * std::log(share) +
                               static_cast<double>(count.trials - count.correct) * std::log1p(-share);
                    }
                    grid = std::max(grid, sum);
                }
            }
        }
        EXPECT_GE(found, grid - 1e-6);
    }
}

TEST(FitStability, extremeAnswersHaveAnAnswer) {
    for (const RiseShape shape : {RiseShape::weibull, RiseShape::gauss, RiseShape::logistic}) {
        for (const auto& correct : std::vector<std::vector<int>>{{0, 0, 0, 0, 0, 0},
                                                                 {1, 1, 1, 1, 1, 1},
                                                                 {0, 0, 0, 1, 1, 1},
                                                                 {1, 0, 1, 0, 1, 0},
                                                                 {0, 1, 0, 1, 0, 1}}) {
            const FitSettings settings = fitSettings(shape, LevelScale::log10, 0.0, 0.0, 0.06);
            const PsychometricFit fit = fitPsychometric(countsOf(kSixLevels, correct, 1), settings);
            EXPECT_TRUE(!fit.threshold || std::isfinite(*fit.threshold));
            const PsychometricFit wide =
                fitPsychometric(countsOf({1e-9, 1e-3, 1.0, 1e3, 1e6, 1e9}, correct, 1), settings);
            EXPECT_TRUE(!wide.threshold || std::isfinite(*wide.threshold));
        }
    }
}

// Hundreds of equal answers leave a posterior that sums to 1.
TEST(FitStability, aPosteriorSurvivesAnyAnswers) {
    BayesSettings settings;
    settings.guess = {0.0};
    settings.lapse = {0.0};
    const BayesGrid grid(settings, LevelRange{});
    BayesTrack track(grid);
    for (int i = 0; i < 300; ++i)
        track.add(i % 2 == 0 ? 0.01 : 1.0, i % 2 == 0); // right at the lowest, wrong at the highest level
    double sum = 0.0;
    for (const double mass : track.thresholdMass())
        sum += mass;
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_TRUE(std::isfinite(track.belief().mean));
    EXPECT_TRUE(std::isfinite(track.bestLevel()));
}

TEST(FitStability, sensitivityOfManyTrialsIsFinite) {
    const auto perfect = yesNoDetection({1'000'000, 1'000'000, 0, 1'000'000});
    EXPECT_NEAR(perfect->sensitivity, 2.0 * 4.8916385, 1e-5); // 2 z(1 - 0.5e-6), from R
    EXPECT_TRUE(std::isfinite(intervalDetection(1'000'000, 1'000'000, 4)->sensitivity));
    EXPECT_TRUE(std::isfinite(intervalDetection(0, 1'000'000, 4)->sensitivity));
}

} // namespace teleta::study
