// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/depth_rate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace teleta::vision {
namespace {

CameraContact deepened(double by_m, double noise_m = 0.0) {
    CameraContact contact;
    contact.depth_m = 0.0005;
    contact.deepened_m = by_m;
    contact.depthNoise_m = noise_m;
    return contact;
}

} // namespace

TEST(DepthRate, isThatOfTheSkinAtTheFirstSightingWhateverTheFrameRate) {
    for (const double rate_Hz : {10.0, 40.0, 80.0}) {
        DepthRate rate;
        rate.add(deepened(0.03 / rate_Hz), 1.0, 1.0 / rate_Hz);
        EXPECT_NEAR(rate.atLeast_mPerS(), 0.03, 1e-12) << rate_Hz;
    }
}

TEST(DepthRate, isTheSlopeOfAStraightLineThroughTheSightings) {
    // 0, 1, 1, 0 at 0, 1, 2, 3: the newest two fall by 1, the newest three by 0.5, and all by
    // (-1.5 * 0 - 0.5 * 1 + 0.5 * 1 + 1.5 * 0) / 5 = 0.
    DepthRate rate;
    constexpr double kPeriod_s = 0.0122;
    rate.add(deepened(1e-4), 1 * kPeriod_s, kPeriod_s);
    rate.add(deepened(0.0), 2 * kPeriod_s, kPeriod_s);
    EXPECT_NEAR(rate.atLeast_mPerS(), 0.5 * 1e-4 / kPeriod_s, 1e-12); // 0, 1, 1: the steepest of all
    rate.add(deepened(-1e-4), 3 * kPeriod_s, kPeriod_s);
    EXPECT_NEAR(rate.atLeast_mPerS(), 0.0, 1e-12);
}

TEST(DepthRate, isTheSurerTheMoreSightingsThereAre) {
    DepthRate rate;
    constexpr double kPeriod_s = 0.0122;
    constexpr double kNoise_m = 1e-4;
    const std::array<double, 4> spread{0.5, 2.0, 5.0, 10.0}; // sum of (i - mean)^2
    for (std::size_t i = 0; i < spread.size(); ++i) {
        rate.add(deepened(0.03 * kPeriod_s, kNoise_m), static_cast<double>(i) * kPeriod_s, kPeriod_s);
        EXPECT_NEAR(rate.atLeast_mPerS(), 0.03 - 3.0 * kNoise_m / (kPeriod_s * std::sqrt(spread[i])), 1e-12);
    }
}

/// As a dot at 64 mm was seen in two frames of 120 a second while a finger came at 6 mm/s.
TEST(DepthRate, isNotMadeByOneStepOfAFastCamera) {
    constexpr double kPeriod_s = 1.0 / 120.0;
    constexpr double kNoise_m = 2.4e-5;
    constexpr std::array kSteps_m{5.6e-5, 5.2e-5, 4.1e-5, 5.6e-5, 2.83e-4, 5e-5, 5e-5};
    DepthRate rate;
    double time_s = 1.0;
    for (const double step_m : kSteps_m) {
        time_s += kPeriod_s;
        rate.add(deepened(step_m, kNoise_m), time_s, kPeriod_s);
        EXPECT_LT(rate.atLeast_mPerS(), 0.02) << time_s;
    }
}

TEST(DepthRate, ofAFastCameraIsKnownAfterTwelveMilliseconds) {
    constexpr double kPeriod_s = 0.002;
    DepthRate rate;
    for (int i = 1; i <= 5; ++i) {
        rate.add(deepened(0.03 * kPeriod_s), i * kPeriod_s, kPeriod_s);
        EXPECT_EQ(rate.atLeast_mPerS(), 0.0) << i;
    }
    // Whether exactly 12 ms are enough is left to rounding.
    rate.add(deepened(0.03 * kPeriod_s), 6 * kPeriod_s, kPeriod_s);
    rate.add(deepened(0.03 * kPeriod_s), 7 * kPeriod_s, kPeriod_s);
    EXPECT_NEAR(rate.atLeast_mPerS(), 0.03, 1e-12);
}

TEST(DepthRate, seesABlowOnAContactThatHasRestedForLong) {
    DepthRate rate;
    constexpr double kPeriod_s = 0.025;
    for (int i = 0; i < 100; ++i)
        rate.add(deepened(0.0, 2e-5), i * kPeriod_s, kPeriod_s);
    EXPECT_LT(rate.atLeast_mPerS(), 0.0);
    rate.add(deepened(0.001, 2e-5), 100 * kPeriod_s, kPeriod_s);
    EXPECT_GT(rate.atLeast_mPerS(), 0.035);
}

TEST(DepthRate, beginsAnewAfterAGapAndIsNotKnownWithoutTheFrameBefore) {
    DepthRate rate;
    EXPECT_EQ(rate.atLeast_mPerS(), 0.0);
    rate.add(deepened(NAN), 0.0, 0.02);
    EXPECT_EQ(rate.atLeast_mPerS(), 0.0);
    rate.add(deepened(2e-4), 0.02, 0.02);
    EXPECT_NEAR(rate.atLeast_mPerS(), 0.01, 1e-12);
    rate.add(deepened(4e-4), 0.1, 0.02); // not seen in the frames between
    EXPECT_NEAR(rate.atLeast_mPerS(), 0.02, 1e-12);
    rate.add(deepened(NAN), 0.2, 0.02);
    EXPECT_EQ(rate.atLeast_mPerS(), 0.0);
    rate.add(deepened(1e-4), 0.2, 0.0); // a time that stands still
    EXPECT_TRUE(std::isfinite(rate.atLeast_mPerS()));
}

TEST(DepthRate, isThatOfTheDepthWhereWhatTheSkinDidIsNotKnown) {
    DepthRate rate;
    CameraContact contact = deepened(NAN);
    rate.add(contact, 0.0, 0.02);
    contact.depth_m += 4e-4;
    rate.add(contact, 0.02, 0.02);
    EXPECT_NEAR(rate.atLeast_mPerS(), 0.02, 1e-12);
}

} // namespace teleta::vision
