// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site/clock_estimator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>

using namespace teleta::site;

namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kSecond = 1'000'000'000;

/// A probe that takes so long there and back between clocks with this offset.
ClockProbe probe(std::int64_t at_ns, std::int64_t offset_ns, std::int64_t there_ns, std::int64_t back_ns) {
    ClockProbe made;
    made.sent_console_ns = at_ns;
    made.received_site_ns = at_ns + there_ns + offset_ns;
    made.answered_site_ns = made.received_site_ns + 50'000;
    made.received_console_ns = made.answered_site_ns - offset_ns + back_ns;
    return made;
}

} // namespace

TEST(ClockEstimator, isExactWhereBothWaysTakeTheSameTime) {
    ClockEstimator clock;
    EXPECT_FALSE(clock.offset(0));
    ASSERT_TRUE(clock.add(probe(kSecond, 7 * kSecond, 20 * kMs, 20 * kMs)));
    const auto offset = clock.offset(kSecond + 40 * kMs + 50'000);
    ASSERT_TRUE(offset);
    EXPECT_EQ(offset->offset_ns, 7 * kSecond);
    EXPECT_EQ(offset->delay_ns, 40 * kMs);
    EXPECT_EQ(offset->bound_ns, 20 * kMs);
}

TEST(ClockEstimator, asymmetryErrsByHalfOfItWithinTheBound) {
    ClockEstimator clock;
    ASSERT_TRUE(clock.add(probe(kSecond, 0, 10 * kMs, 30 * kMs)));
    const auto offset = clock.offset(kSecond + 40 * kMs);
    EXPECT_EQ(offset->offset_ns, -10 * kMs);
    EXPECT_LE(std::abs(offset->offset_ns), offset->bound_ns);
}

TEST(ClockEstimator, theBoundGrowsWithTheAge) {
    ClockEstimator clock;
    ASSERT_TRUE(clock.add(probe(0, 0, kMs, kMs)));
    const std::int64_t received_ns = 2 * kMs + 50'000;
    EXPECT_EQ(clock.offset(received_ns + 100 * kSecond)->bound_ns, kMs + 10 * kMs); // 100e-6 * 100 s
}

TEST(ClockEstimator, theBoundHoldsOverLinksWithJitterLossAsymmetryAndDrift) {
    std::mt19937_64 random(5);
    std::exponential_distribution<double> jitter_ms(1.0 / 5.0);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    for (int link = 0; link < 50; ++link) {
        const double drift = 80e-6 * (2.0 * any(random) - 1.0); // of one clock against the other
        const double there_ms = 40.0 * any(random);
        const double back_ms = 40.0 * any(random);
        ClockEstimator clock;
        for (int i = 0; i < 1000; ++i) {
            const std::int64_t at_ns = kSecond + i * kSecond / 4;
            const auto trueOffset_ns =
                3 * kSecond + static_cast<std::int64_t>(drift * static_cast<double>(at_ns));
            if (any(random) < 0.03)
                continue;
            const ClockProbe made =
                probe(at_ns, trueOffset_ns, static_cast<std::int64_t>((there_ms + jitter_ms(random)) * 1e6),
                      static_cast<std::int64_t>((back_ms + jitter_ms(random)) * 1e6));
            ASSERT_TRUE(clock.add(made));
            const std::int64_t now_ns = made.received_console_ns + 200 * kMs;
            const auto nowOffset_ns =
                3 * kSecond + static_cast<std::int64_t>(drift * static_cast<double>(now_ns));
            const auto known = clock.offset(now_ns);
            ASSERT_LE(std::abs(known->offset_ns - nowOffset_ns), known->bound_ns + 1);
        }
        EXPECT_EQ(clock.jumps(), 0U);
    }
}

TEST(ClockEstimator, forgetsWhatItKnewWhenAClockJumps) {
    ClockEstimator clock;
    for (int i = 0; i < 10; ++i)
        ASSERT_TRUE(clock.add(probe(i * kSecond, kSecond, kMs, kMs)));
    // The console slept for an hour: its clock stood still.
    ASSERT_TRUE(clock.add(probe(11 * kSecond, 3601 * kSecond, 9 * kMs, 9 * kMs)));
    EXPECT_EQ(clock.jumps(), 1U);
    EXPECT_EQ(clock.offset(12 * kSecond)->offset_ns, 3601 * kSecond);
}

TEST(ClockEstimator, ignoresTimesThatCannotBe) {
    ClockEstimator clock;
    ClockProbe early = probe(kSecond, 0, kMs, kMs);
    early.answered_site_ns = early.received_site_ns - 1;
    EXPECT_FALSE(clock.add(early));
    ClockProbe negative = probe(kSecond, 0, kMs, kMs);
    negative.answered_site_ns += 5 * kMs; // longer at the site than away from the console
    EXPECT_FALSE(clock.add(negative));
    for (const std::int64_t wild : {std::numeric_limits<std::int64_t>::min(), std::int64_t{-1},
                                    std::numeric_limits<std::int64_t>::max()}) {
        ClockProbe lie = probe(kSecond, 0, kMs, kMs);
        lie.received_site_ns = wild;
        EXPECT_FALSE(clock.add(lie));
    }
    EXPECT_EQ(clock.ignored(), 5U);
    EXPECT_FALSE(clock.offset(kSecond));
}

TEST(SlewedOffset, followsByOneMillisecondASecond) {
    SlewedOffset shown;
    EXPECT_EQ(shown.follow(5 * kMs, 0), 5 * kMs);
    EXPECT_EQ(shown.follow(10 * kMs, kSecond), 6 * kMs);
    EXPECT_EQ(shown.follow(10 * kMs, 3 * kSecond), 8 * kMs);
    EXPECT_EQ(shown.follow(10 * kMs, 10 * kSecond), 10 * kMs);
    EXPECT_EQ(shown.follow(9 * kMs + 999'999, 10 * kSecond + kMs), 9 * kMs + 999'999);
}
