// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/recent_times.h"

#include <gtest/gtest.h>

using teleta::playback::RecentTimes;

TEST(RecentTimes, isZeroWithoutAny) {
    const RecentTimes times;
    EXPECT_EQ(times.median_ns(), 0);
    EXPECT_EQ(times.longest_ns(), 0);
    EXPECT_EQ(times.count(), 0U);
}

TEST(RecentTimes, givesTheMiddleOneAndTheLongest) {
    RecentTimes times;
    for (const std::int64_t time_ns : {30, 10, 50})
        times.add(time_ns);
    EXPECT_EQ(times.median_ns(), 30);
    EXPECT_EQ(times.longest_ns(), 50);
    times.add(20);
    EXPECT_EQ(times.median_ns(), 20) << "the lower of 20 and 30";
}

TEST(RecentTimes, forgetsOldOnesButNotTheLongest) {
    RecentTimes times;
    times.add(1'000'000);
    for (std::size_t i = 0; i < RecentTimes::kKept; ++i)
        times.add(1000);
    for (std::size_t i = 0; i < RecentTimes::kKept / 2 + 1; ++i)
        times.add(7);
    EXPECT_EQ(times.median_ns(), 7);
    EXPECT_EQ(times.longest_ns(), 1'000'000);
    times.clear();
    EXPECT_EQ(times.longest_ns(), 0);
    EXPECT_EQ(times.count(), 0U);
}
