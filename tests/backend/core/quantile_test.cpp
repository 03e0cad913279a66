// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/quantile.h"

#include <gtest/gtest.h>

#include <array>

using teleta::core::quantileOf;

TEST(Quantile, isThatOfR) {
    // R: quantile(c(1, 2, 4, 8), c(0, .25, .5, .95, 1)) gives 1, 1.75, 3, 7.4, 8.
    constexpr std::array kValues{1.0, 2.0, 4.0, 8.0};
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 0.5), 3.0);
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 0.95), 7.4);
    EXPECT_DOUBLE_EQ(quantileOf(kValues, 1.0), 8.0);
    EXPECT_DOUBLE_EQ(quantileOf(std::span(kValues).first(1), 0.99), 1.0);
}
