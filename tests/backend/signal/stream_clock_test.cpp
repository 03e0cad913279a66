// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/stream_clock.h"

#include <gtest/gtest.h>

using teleta::signal::StreamClock;

TEST(StreamClock, stepsByTheStreamsOwnTime) {
    StreamClock clock(1'000'000'000, 200.0);
    EXPECT_DOUBLE_EQ(clock.next(3'000'000'000, 70.0, false).time_s, 2.0);
    const auto step = clock.next(3'009'000'000, 70.005, false); // read late
    EXPECT_NEAR(step.time_s, 2.005, 1e-12);
    EXPECT_FALSE(step.gap);
}

TEST(StreamClock, missingFramesAreAGap) {
    StreamClock clock(0, 200.0);
    EXPECT_FALSE(clock.next(0, 0.0, false).gap);
    EXPECT_FALSE(clock.next(90'000'000, 0.09, false).gap);
    EXPECT_TRUE(clock.next(300'000'000, 0.3, false).gap);
    StreamClock events(0, 0.0);
    EXPECT_FALSE(events.next(0, 0.0, false).gap);
    EXPECT_FALSE(events.next(90'000'000'000, 90.0, false).gap) << "they come when they please";
}

TEST(StreamClock, aJumpIsPutOnTheClockAnew) {
    StreamClock clock(0, 100.0);
    EXPECT_DOUBLE_EQ(clock.next(1'000'000'000, 50.0, false).time_s, 1.0);
    const auto back = clock.next(1'200'000'000, 10.0, false);
    EXPECT_DOUBLE_EQ(back.time_s, 1.2);
    EXPECT_TRUE(back.gap);
    const auto marked = clock.next(1'300'000'000, 10.01, true);
    EXPECT_DOUBLE_EQ(marked.time_s, 1.3);
    EXPECT_TRUE(marked.gap);
}

TEST(StreamClock, aHeldStreamComesBackWhereTheClockIs) {
    StreamClock clock(0, 100.0);
    EXPECT_FALSE(clock.next(0, 0.0, false).gap);
    const auto step = clock.next(60'000'000'000, 0.01, false);
    EXPECT_DOUBLE_EQ(step.time_s, 60.0);
    EXPECT_TRUE(step.gap);
}

TEST(StreamClock, aStreamThatRunsFastNeverGoesBack) {
    StreamClock clock(0, 100.0);
    EXPECT_DOUBLE_EQ(clock.next(0, 0.0, false).time_s, 0.0);
    EXPECT_DOUBLE_EQ(clock.next(10'000'000, 5.0, false).time_s, 5.0);
    EXPECT_DOUBLE_EQ(clock.next(20'000'000, 1.0, true).time_s, 5.0);
}
