// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/source_clock.h"

#include <gtest/gtest.h>

using teleta::ros::SourceClock;
using teleta::ros::Time;

namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;

Time stamp(std::int32_t sec, std::uint32_t nanosec) {
    Time time{};
    time.sec = sec;
    time.nanosec = nanosec;
    return time;
}

} // namespace

TEST(SourceClock, beginsAtZeroAndFollowsTheStamps) {
    SourceClock clock;
    EXPECT_FALSE(clock.lastRead_ns());
    const Time first = stamp(1000, 0);
    const Time second = stamp(1000, 250'000'000);
    EXPECT_EQ(clock.at(&first, 5 * kMillisecond_ns), 0.0);
    // It was long on its way.
    EXPECT_EQ(clock.at(&second, 905 * kMillisecond_ns), 0.25);
    EXPECT_EQ(clock.lastRead_ns(), 905 * kMillisecond_ns);
    EXPECT_EQ(clock.oddStamps(), 0U);
}

TEST(SourceClock, withoutStampsOurClockGoesOn) {
    SourceClock clock;
    EXPECT_EQ(clock.at(nullptr, 7 * kMillisecond_ns), 0.0);
    EXPECT_DOUBLE_EQ(clock.at(nullptr, 17 * kMillisecond_ns), 0.01);
    EXPECT_EQ(clock.oddStamps(), 0U);
}

TEST(SourceClock, stampsThatDoNotRiseAreCountedAndReplaced) {
    SourceClock clock;
    const Time first = stamp(10, 0);
    const Time back = stamp(9, 0);
    const Time zero = stamp(0, 0);
    const Time next = stamp(9, 500'000'000);
    EXPECT_EQ(clock.at(&first, 0), 0.0);
    EXPECT_DOUBLE_EQ(clock.at(&first, 10 * kMillisecond_ns), 0.01);
    EXPECT_DOUBLE_EQ(clock.at(&back, 30 * kMillisecond_ns), 0.03);
    EXPECT_DOUBLE_EQ(clock.at(&zero, 40 * kMillisecond_ns), 0.04);
    EXPECT_EQ(clock.oddStamps(), 3U);
    // After a zero stamp it is not known how long the step was.
    EXPECT_DOUBLE_EQ(clock.at(&next, 50 * kMillisecond_ns), 0.05);
    EXPECT_EQ(clock.oddStamps(), 3U);
}
