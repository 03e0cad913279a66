// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/time_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using teleta::playback::TimeHistogram;

TEST(TimeHistogram, knowsQuantilesOfManyDecadesToTheWidthOfABucket) {
    TimeHistogram histogram;
    std::vector<std::int64_t> times_ns;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> decades(0.0, 10.0);
    for (int k = 0; k < 20'000; ++k) {
        times_ns.push_back(static_cast<std::int64_t>(std::pow(10.0, decades(random))));
        histogram.add(times_ns.back());
    }
    std::ranges::sort(times_ns);
    for (const double share : {0.001, 0.1, 0.5, 0.9, 0.99, 1.0}) {
        const auto index = static_cast<std::size_t>(std::ceil(share * 20'000.0)) - 1;
        const auto exact = static_cast<double>(times_ns[index]);
        const auto found = static_cast<double>(histogram.quantile_ns(share));
        EXPECT_GE(found, exact) << share;
        EXPECT_LE(found, exact * (1.0 + 1.0 / 32.0) + 1.0) << share;
    }
    EXPECT_EQ(histogram.longest_ns(), times_ns.back());
    EXPECT_EQ(histogram.count(), 20'000U);
}

TEST(TimeHistogram, takesTheEndsOfTheRange) {
    TimeHistogram histogram;
    EXPECT_EQ(histogram.quantile_ns(0.5), 0);
    histogram.add(-5);
    histogram.add(std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(histogram.quantile_ns(0.5), 0);
    EXPECT_EQ(histogram.quantile_ns(1.0), std::numeric_limits<std::int64_t>::max());
    histogram.clear();
    EXPECT_EQ(histogram.count(), 0U);
}
