// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace teleta;
using pipeline::setPlaceErrors;
using pipeline::SkinContact;

namespace {

constexpr double kPitch_m = 0.0094;
const core::ArrayLayout kGrid{20, 24, kPitch_m};
constexpr double kThreshold_N = 0.02;

/// A press of some force between taxels, whose load spreads like a Gaussian bell; taxels below the threshold
/// do not count.
contact::Contact press(double column, double row, double force_N, double width, std::mt19937_64& random) {
    constexpr int kAround = 8;
    std::normal_distribution<double> noise(0.0, kThreshold_N / 5.0);
    contact::Contact patch{
        .minRow = kAround, .maxRow = -kAround, .minColumn = kAround, .maxColumn = -kAround};
    for (int r = -kAround; r <= kAround; ++r)
        for (int c = -kAround; c <= kAround; ++c) {
            const double away2 = std::pow(c - column, 2) + std::pow(r - row, 2);
            const double load_N = force_N * std::exp(-0.5 * away2 / (width * width)) /
                                      (2.0 * 3.141592653589793 * width * width) +
                                  noise(random);
            if (load_N < kThreshold_N)
                continue;
            patch.force_N += load_N;
            patch.x_m += load_N * c * kPitch_m;
            patch.minRow = std::min(patch.minRow, r);
            patch.maxRow = std::max(patch.maxRow, r);
            patch.minColumn = std::min(patch.minColumn, c);
            patch.maxColumn = std::max(patch.maxColumn, c);
        }
    if (patch.force_N > 0.0)
        patch.x_m /= patch.force_N;
    return patch;
}

} // namespace

TEST(PlaceErrors, areThoseOfPressesOfAllSizesAndForces) {
    std::mt19937_64 random(1);
    for (const double width : {0.55, 0.7, 0.9, 1.2}) {
        for (const double force_N : {0.15, 0.25, 0.4, 1.0, 2.0}) {
            int presses = 0;
            int within = 0;
            double squares = 0.0;
            for (int i = 0; i < 20; ++i)
                for (int j = 0; j < 20; ++j) {
                    const double column = (i + 0.5) / 20.0;
                    const auto patch = press(column, (j + 0.5) / 20.0, force_N, width, random);
                    // So gentle that some presses are hardly felt.
                    if (patch.force_N < 0.5 * force_N)
                        continue;
                    SkinContact contact;
                    setPlaceErrors(contact, patch, kGrid, kThreshold_N);
                    const double over_se = (patch.x_m - column * kPitch_m) / contact.xSe_m;
                    ++presses;
                    within += std::abs(over_se) < 1.96 ? 1 : 0;
                    squares += over_se * over_se;
                }
            if (presses < 100)
                continue;
            EXPECT_GE(within, 0.95 * presses) << width << " pitches, " << force_N << " N";
            EXPECT_GE(std::sqrt(squares / presses), 0.3) << width << " pitches, " << force_N << " N";
        }
    }
}

// 0.02 / 2 N of sqrt(3) taxels, (4 + 1) / 2 pitches away, of 0.5 N.
TEST(PlaceErrors, followThresholdSizeAndForce) {
    SkinContact contact;
    const contact::Contact patch{.force_N = 0.5, .minRow = 4, .maxRow = 6, .minColumn = 1, .maxColumn = 4};
    setPlaceErrors(contact, patch, kGrid, kThreshold_N);
    EXPECT_NEAR(contact.xSe_m, 0.01 * std::sqrt(3.0) * 2.5 * kPitch_m / 0.5, 1e-12);
    EXPECT_NEAR(contact.ySe_m, 0.01 * std::sqrt(4.0) * 2.0 * kPitch_m / 0.5, 1e-12);
    // Each axis has its own pitch.
    SkinContact wide;
    setPlaceErrors(wide, patch, {20, 24, kPitch_m, 2.0 * kPitch_m}, kThreshold_N);
    EXPECT_EQ(wide.xSe_m, contact.xSe_m);
    EXPECT_NEAR(wide.ySe_m, 2.0 * contact.ySe_m, 1e-15);
    SkinContact exact;
    setPlaceErrors(exact, patch, kGrid, 0.0);
    EXPECT_EQ(exact.xSe_m, 0.0);
}

TEST(PlaceErrors, ofAContactWithoutForceAreNotKnown) {
    SkinContact contact;
    setPlaceErrors(contact, {}, kGrid, kThreshold_N);
    EXPECT_EQ(contact.xSe_m, 0.0);
    EXPECT_EQ(contact.ySe_m, 0.0);
}
