// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/robust_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using teleta::equilibration::robustSlope;
using teleta::equilibration::Slope;

namespace {

Slope slopeOf(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> buffer;
    return robustSlope(x, y, buffer);
}

} // namespace

TEST(RobustSlope, ofALineIsTheLine) {
    const Slope slope = slopeOf({1.0, 2.0, -3.0, 0.5}, {2.5, 5.0, -7.5, 1.25});
    EXPECT_DOUBLE_EQ(slope.slope, 2.5);
    EXPECT_EQ(slope.noise, 0.0);
    EXPECT_NEAR(slope.error, 0.0, 1e-15);
}

TEST(RobustSlope, ofOneValueIsItsRatio) {
    const Slope slope = slopeOf({4.0}, {6.0});
    EXPECT_DOUBLE_EQ(slope.slope, 1.5);
    EXPECT_EQ(slope.error, 0.0);
}

TEST(RobustSlope, isLeastSquaresWhereNothingIsFarOff) {
    // By hand: sum xy / sum x^2 = (1.1 + 3.8 + 9.3) / 14; no residual beyond 1.345 scales.
    const Slope slope = slopeOf({1.0, 2.0, 3.0}, {1.1, 1.9, 3.1});
    EXPECT_NEAR(slope.slope, 14.2 / 14.0, 1e-12);
}

TEST(RobustSlope, isOnTheLineOfMostValuesWhenTheyAreExact) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 1; i <= 20; ++i) {
        x.push_back(i);
        y.push_back(i % 5 == 0 ? 1e9 : 3.0 * i);
    }
    EXPECT_NEAR(slopeOf(x, y).slope, 3.0, 1e-6);
}

TEST(RobustSlope, errorIsThatOfTheLeastSquaresSlopeForNormalNoise) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    double squares = 0.0;
    double said = 0.0;
    constexpr int kRuns = 2000;
    for (int run = 0; run < kRuns; ++run) {
        std::vector<double> x;
        std::vector<double> y;
        for (int i = 0; i < 50; ++i) {
            x.push_back(1.0 + 0.02 * i);
            y.push_back(2.0 * x.back() + 0.1 * normal(random));
        }
        const Slope slope = slopeOf(x, y);
        squares += std::pow(slope.slope - 2.0, 2) / kRuns;
        said += slope.error / kRuns;
    }
    // Huber's efficiency at the normal distribution is 95 %.
    EXPECT_NEAR(said / std::sqrt(squares), 1.0, 0.06);
}
