// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/residual_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace teleta::stiffness;

TEST(VarianceInflation, isOneForIndependentResiduals) {
    int inflated = 0;
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        std::vector<double> residuals(200);
        for (double& residual : residuals)
            residual = normal(random);
        inflated += varianceInflation(residuals, 2) > 1.0 ? 1 : 0;
    }
    EXPECT_LE(inflated, 3);
}

TEST(VarianceInflation, isThatOfAProcessOfFirstOrder) {
    // (1 + r) / (1 - r) for the mean: 9 at r = 0.8.
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    double state = 0.0;
    std::vector<double> residuals(20'000);
    for (double& residual : residuals)
        residual = state = 0.8 * state + 0.6 * normal(random);
    // Eight blocks scatter: the largest of the estimates is too careful rather than too small.
    EXPECT_GT(varianceInflation(residuals, 2), 8.0);
    EXPECT_LT(varianceInflation(residuals, 2), 30.0);
}

TEST(VarianceInflation, isOneForTooFewAndForZeroResiduals) {
    EXPECT_EQ(varianceInflation({}, 2), 1.0);
    EXPECT_EQ(varianceInflation(std::vector<double>(15, 1.0), 2), 1.0);
    EXPECT_EQ(varianceInflation(std::vector<double>(100, 0.0), 2), 1.0);
}

TEST(FitBend, findsTheSlopesOfAParabola) {
    // y = 1 + 2 x + x^2 on 0 .. 1: slopes 2 and 4, mean 3.
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i <= 50; ++i) {
        x.push_back(0.02 * i);
        y.push_back(1.0 + 2.0 * x.back() + x.back() * x.back());
    }
    const auto bend = fitBend(x, y);
    ASSERT_TRUE(bend);
    EXPECT_NEAR(bend->firstSlope, 2.0, 1e-9);
    EXPECT_NEAR(bend->lastSlope, 4.0, 1e-9);
    EXPECT_NEAR(bend->change, 2.0 / 3.0, 1e-9);
    EXPECT_NEAR(bend->se, 0.0, 1e-9);
}

TEST(FitBend, isEmptyWithoutASlope) {
    const std::vector<double> x{1, 1, 1, 1, 1, 1, 1, 1, 1};
    const std::vector<double> y{1, 2, 3, 4, 5, 6, 7, 8, 9};
    EXPECT_FALSE(fitBend(x, y));
    EXPECT_FALSE(fitBend(y, x));
    EXPECT_FALSE(fitBend(std::vector<double>{1, 2}, std::vector<double>{1, 2}));
}

TEST(ReadingStep, isFoundWhereTheValuesShowIt) {
    std::vector<double> values;
    for (int i = 0; i < 200; ++i)
        values.push_back(0.005 * std::round(0.0003 * i / 0.005));
    ASSERT_TRUE(readingStep(values));
    EXPECT_NEAR(*readingStep(values), 0.005, 1e-12);
}

TEST(ReadingStep, isEmptyForContinuousAndForConstantValues) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::vector<double> values(200);
    for (double& value : values)
        value = normal(random);
    EXPECT_FALSE(readingStep(values));
    EXPECT_FALSE(readingStep(std::vector<double>(200, 1.0)));
    EXPECT_FALSE(readingStep({}));
}
