// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/link/frame_clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::link {
namespace {

constexpr double kTick_s = 1e-3;
constexpr double kTolerance_s = 1e-9;

TEST(FrameClock, startsAtTheHostsTimeAndFollowsTheSensor) {
    FrameClock clock(kTick_s);
    EXPECT_NEAR(clock.advance(123456, 0.25).time_s, 0.25, kTolerance_s);
    EXPECT_NEAR(clock.advance(123466, 0.90).time_s, 0.26, kTolerance_s);
    EXPECT_NEAR(clock.advance(123477, 0.91).time_s, 0.271, kTolerance_s);
}

TEST(FrameClock, goesOnWhenTheTimestampWraps) {
    FrameClock clock(kTick_s);
    std::uint32_t timestamp = 0xFFFFFFFFU - 24;
    double expected_s = 1.0;
    for (int i = 0; i < 6; ++i) {
        const FrameClock::Step step = clock.advance(timestamp, 1.0);
        EXPECT_NEAR(step.time_s, expected_s, kTolerance_s);
        EXPECT_EQ(step.lost, 0U);
        EXPECT_FALSE(step.restarted);
        timestamp += 10;
        expected_s += 0.010;
    }
    EXPECT_LT(timestamp, 100U);
}

TEST(FrameClock, countsTheFramesOfAGap) {
    for (const std::uint32_t period : {2U, 3U, 10U, 1000U}) {
        for (const std::uint32_t missing : {1U, 2U, 9U, 250U}) {
            if (period < 3 && missing == 1)
                continue; // two ticks more than a period of two may be rounding
            FrameClock clock(kTick_s);
            std::uint32_t timestamp = 77;
            for (int i = 0; i < 5; ++i, timestamp += period)
                EXPECT_EQ(clock.advance(timestamp, 0.0).lost, 0U);
            timestamp += missing * period;
            EXPECT_EQ(clock.advance(timestamp, 0.0).lost, missing) << period;
            EXPECT_EQ(clock.advance(timestamp + period, 0.0).lost, 0U);
        }
    }
}

TEST(FrameClock, countsTheFramesOfAGapWhenThePeriodIsNoWholeNumberOfTicks) {
    constexpr double kPeriod = 3.7;
    for (const int missing : {1, 2, 5, 20}) {
        FrameClock clock(kTick_s);
        int frame = 0;
        const auto stamp = [](int number) {
            return static_cast<std::uint32_t>(std::floor(kPeriod * number));
        };
        for (; frame < 200; ++frame)
            EXPECT_EQ(clock.advance(stamp(frame), 0.0).lost, 0U) << frame;
        frame += missing;
        EXPECT_EQ(clock.advance(stamp(frame), 0.0).lost, static_cast<std::uint64_t>(missing));
    }
}

TEST(FrameClock, forgetsAGapInTheVeryFirstInterval) {
    FrameClock clock(kTick_s);
    EXPECT_EQ(clock.advance(0, 0.0).lost, 0U);
    EXPECT_EQ(clock.advance(100, 0.0).lost, 0U);
    EXPECT_EQ(clock.advance(110, 0.0).lost, 0U);
    EXPECT_EQ(clock.advance(120, 0.0).lost, 0U);
    EXPECT_EQ(clock.advance(150, 0.0).lost, 2U);
}

TEST(FrameClock, countsNothingForARepeatedTimestamp) {
    FrameClock clock(kTick_s);
    for (int i = 0; i < 4; ++i) {
        const FrameClock::Step step = clock.advance(500, 2.0);
        EXPECT_NEAR(step.time_s, 2.0, kTolerance_s);
        EXPECT_EQ(step.lost, 0U);
    }
}

TEST(FrameClock, noticesThatTheSensorStartedAnew) {
    FrameClock clock(kTick_s);
    (void)clock.advance(90000, 0.0);
    (void)clock.advance(90010, 0.01);
    const FrameClock::Step step = clock.advance(5, 7.5);
    EXPECT_TRUE(step.restarted);
    EXPECT_EQ(step.lost, 0U);
    EXPECT_NEAR(step.time_s, 7.5, kTolerance_s);
    EXPECT_NEAR(clock.advance(15, 7.6).time_s, 7.51, kTolerance_s);
}

TEST(FrameClock, neverGoesBackWhenAConnectionBegins) {
    FrameClock clock(kTick_s);
    (void)clock.advance(0, 1.0);
    (void)clock.advance(5000, 1.1);
    clock.restart();
    const FrameClock::Step step = clock.advance(3, 5.0);
    EXPECT_NEAR(step.time_s, 6.0, kTolerance_s);
    EXPECT_FALSE(step.restarted);
    EXPECT_EQ(step.lost, 0U);
}

} // namespace
} // namespace teleta::link
