// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/derivative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace teleta::signal;

TEST(Derivative, isExactForAParabolaOnUnevenTimes) {
    Series series;
    double time_s = 0.0;
    for (int i = 0; i < 50; ++i) {
        series.append(time_s, 3.0 * time_s * time_s - 2.0 * time_s + 1.0);
        time_s += i % 3 == 0 ? 0.01 : 0.037;
    }
    Derivative derivative;
    EXPECT_FALSE(derivative.follow(series, 1000));
    ASSERT_EQ(derivative.series().size(), 48U) << "the ends have none";
    for (std::size_t i = 0; i < 48; ++i) {
        EXPECT_DOUBLE_EQ(derivative.series().time_s(i), series.time_s(i + 1));
        EXPECT_NEAR(derivative.series().value(i), 6.0 * derivative.series().time_s(i) - 2.0, 1e-11);
    }
}

TEST(Derivative, doesNotReachOverAGap) {
    Series series;
    for (int i = 0; i < 5; ++i)
        series.append(i, i);
    series.lift();
    for (int i = 100; i < 105; ++i)
        series.append(i, -i);
    Derivative derivative;
    derivative.follow(series, 1000);
    const Series& slopes = derivative.series();
    ASSERT_EQ(slopes.size(), 7U);
    EXPECT_EQ(slopes.value(2), 1.0);
    EXPECT_TRUE(std::isnan(slopes.value(3)));
    EXPECT_EQ(slopes.value(4), -1.0);
}

TEST(Derivative, catchesUpInStepsAndFollowsWhatComes) {
    Series series;
    for (int i = 0; i < 1000; ++i)
        series.append(i, 2.0 * i);
    Derivative derivative;
    EXPECT_TRUE(derivative.follow(series, 300));
    EXPECT_EQ(derivative.series().size(), 298U);
    while (derivative.follow(series, 300)) {
    }
    EXPECT_EQ(derivative.series().size(), 998U);
    series.append(1000, 2000.0);
    EXPECT_FALSE(derivative.follow(series, 300));
    EXPECT_EQ(derivative.series().size(), 999U);
    EXPECT_EQ(derivative.series().newest(), 2.0);
}

TEST(Derivative, twoSamplesOfOneTimeMakeNoInfinity) {
    Series series;
    for (const double time_s : {0.0, 1.0, 1.0, 2.0, 3.0})
        series.append(time_s, time_s == 1.0 && series.size() == 2 ? 50.0 : time_s);
    Derivative derivative;
    derivative.follow(series, 10);
    ASSERT_EQ(derivative.series().size(), 2U);
    EXPECT_EQ(derivative.series().value(0), 1.0);
    EXPECT_EQ(derivative.series().value(1), 1.0);
}
