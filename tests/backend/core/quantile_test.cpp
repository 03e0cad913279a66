// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/quantile.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

using namespace teleta::core;

TEST(Quantile, isThatOfR) {
    // R: quantile(c(1, 2, 4, 8), c(0, .25, .5, .95, 1)) gives 1, 1.75, 3, 7.4, 8.
    constexpr std::array<double, 4> kValues{1.0, 2.0, 4.0, 8.0};
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 0.5), 3.0);
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 0.95), 7.4);
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 1.0), 8.0);
    EXPECT_DOUBLE_EQ(quantileOf(std::span(kValues).first(1), 0.99), 1.0);
}

TEST(Quantile, orderStatisticsAreThoseOfTheSortedValues) {
    const std::vector<int> values{7, 1, 5, 3, 3};
    const std::vector<int> sorted{1, 3, 3, 5, 7};
    for (std::size_t rank = 0; rank < sorted.size(); ++rank)
        EXPECT_EQ(orderStatistic(std::vector(values), rank), sorted[rank]);
}

TEST(Quantile, mediansOfAnEvenNumberDifferByTheirDefinition) {
    EXPECT_EQ(medianOf(std::vector{3.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(medianOf(std::vector{4.0, 1.0, 2.0, 3.0}), 2.5);
    EXPECT_EQ(medianOf(std::vector{5.0}), 5.0);
    EXPECT_EQ(upperMedianOf(std::vector{3.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(upperMedianOf(std::vector{4.0, 1.0, 2.0, 3.0}), 3.0);
}

TEST(Quantile, theMedianOfUnboundedValuesIsUnbounded) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(medianOf(std::vector{1.0, kInfinity}), kInfinity);
    EXPECT_EQ(medianOf(std::vector{kInfinity, kInfinity}), kInfinity);
}

TEST(Quantile, theLowerQuantileDoesNotInterpolate) {
    EXPECT_EQ(lowerQuantileOf(std::vector{8.0F, 1.0F, 4.0F, 2.0F}, 0.5), 2.0F);
    EXPECT_EQ(lowerQuantileOf(std::vector{8.0F, 1.0F, 4.0F, 2.0F}, 0.99), 4.0F);
    EXPECT_EQ(lowerQuantileOf(std::vector{8.0F, 1.0F, 4.0F, 2.0F}, 1.0), 8.0F);
}
