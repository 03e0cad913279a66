// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/rate_meter.h"

#include <gtest/gtest.h>

using teleta::core::RateMeter;

namespace {
constexpr std::int64_t kSecond_ns = 1'000'000'000;
}

TEST(RateMeter, measuresASteadyStream) {
    RateMeter meter(kSecond_ns);
    for (int sample = 0; sample <= 200; ++sample)
        meter.add(sample * kSecond_ns / 200);
    EXPECT_DOUBLE_EQ(meter.rate_Hz(kSecond_ns), 200.0);
}

TEST(RateMeter, isZeroWithoutTwoSamplesAndAfterTheStreamEnded) {
    RateMeter meter(kSecond_ns);
    EXPECT_EQ(meter.rate_Hz(0), 0.0);
    meter.add(0);
    EXPECT_EQ(meter.rate_Hz(1), 0.0);
    meter.add(0);
    EXPECT_EQ(meter.rate_Hz(1), 0.0) << "two samples at one instant have no rate";
    meter.add(kSecond_ns / 2);
    EXPECT_GT(meter.rate_Hz(kSecond_ns), 0.0);
    EXPECT_EQ(meter.rate_Hz(2 * kSecond_ns), 0.0);
}

TEST(RateMeter, followsAChangeAndSurvivesMoreSamplesThanItKeeps) {
    RateMeter meter(kSecond_ns, 16);
    std::int64_t time_ns = 0;
    for (int sample = 0; sample < 1000; ++sample, time_ns += kSecond_ns / 1000)
        meter.add(time_ns);
    EXPECT_NEAR(meter.rate_Hz(time_ns), 1000.0, 1e-9);
    for (int sample = 0; sample < 40; ++sample, time_ns += kSecond_ns / 20)
        meter.add(time_ns);
    EXPECT_NEAR(meter.rate_Hz(time_ns), 20.0, 1e-9);
}

TEST(RateMeter, startsAnewWhenTimeGoesBack) {
    RateMeter meter(kSecond_ns);
    meter.add(10 * kSecond_ns);
    meter.add(9 * kSecond_ns);
    EXPECT_EQ(meter.rate_Hz(10 * kSecond_ns), 0.0);
    meter.add(9 * kSecond_ns + kSecond_ns / 10);
    EXPECT_DOUBLE_EQ(meter.rate_Hz(9 * kSecond_ns + kSecond_ns / 10), 10.0);
}
