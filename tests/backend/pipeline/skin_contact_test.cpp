// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace teleta;
using pipeline::joinAtSeam;
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

namespace {

/// A sheet that goes all around: 24 rows of 9.4 mm.
constexpr double kAround_m = 24 * kPitch_m;

contact::Contact partAt(int id, double x_m, double y_m, double force_N) {
    contact::Contact part;
    part.id = part.region = id;
    part.x_m = x_m;
    part.y_m = y_m;
    part.force_N = force_N;
    return part;
}

pipeline::TouchSnapshot frameOf(std::vector<contact::Contact> contacts) {
    pipeline::TouchSnapshot frame;
    frame.layout = core::ArrayLayout{24, 24, kPitch_m};
    frame.contacts = std::move(contacts);
    frame.features.copX_m = frame.features.copY_m = frame.features.cocX_m = frame.features.cocY_m = 0.0;
    frame.features.alphaZ_rad = 0.5;
    return frame;
}

} // namespace

// 3 N half a taxel before the seam and 1 N a whole one behind it: a quarter of 1.5 pitches from the first.
TEST(Seam, partsOnBothSidesAreOneContact) {
    auto frame = frameOf({partAt(7, 0.01, 11.5 * kPitch_m, 3.0), partAt(4, 0.014, -11.0 * kPitch_m, 1.0)});
    joinAtSeam(frame, kAround_m);
    EXPECT_EQ(frame.contacts[0].id, 4);
    EXPECT_EQ(frame.contacts[1].id, 4);
    EXPECT_EQ(frame.contacts[0].region, 7) << "their taxels stay apart";
    EXPECT_NEAR(frame.features.copX_m.value(), 0.011, 1e-12);
    EXPECT_NEAR(frame.features.copY_m.value(), (11.5 + 0.25 * 1.5) * kPitch_m, 1e-12);
    EXPECT_FALSE(frame.features.cocX_m || frame.features.cocY_m || frame.features.alphaZ_rad);
    const auto strongest = strongestContact(frame, kAround_m);
    EXPECT_NEAR(strongest.y_m, frame.features.copY_m.value(), 1e-12);
    // 12.3 pitches from the middle lie beyond the upper edge: near the lower one.
    auto beyond = frameOf({partAt(1, 0.0, 11.5 * kPitch_m, 3.0), partAt(2, 0.0, -10.5 * kPitch_m, 2.0)});
    joinAtSeam(beyond, kAround_m);
    EXPECT_NEAR(beyond.features.copY_m.value(), (12.3 - 24.0) * kPitch_m, 1e-12);
}

TEST(Seam, whatDoesNotMeetStaysApart) {
    const std::vector<contact::Contact> apart{
        partAt(1, 0.0, 11.5 * kPitch_m, 3.0), partAt(2, 0.0, -8.0 * kPitch_m, 2.0),
        partAt(3, 4.0 * kPitch_m, -11.5 * kPitch_m, 1.0), partAt(5, 0.0, 9.5 * kPitch_m, 0.5)};
    auto frame = frameOf(apart);
    joinAtSeam(frame, kAround_m);
    for (std::size_t i = 0; i < apart.size(); ++i)
        EXPECT_EQ(frame.contacts[i].id, apart[i].id);
    EXPECT_TRUE(frame.features.cocX_m && frame.features.alphaZ_rad);
    // A flat sheet has no seam, and an identity is needed to share one.
    auto flat = frameOf({partAt(1, 0.0, 11.5 * kPitch_m, 3.0), partAt(2, 0.0, -11.5 * kPitch_m, 1.0)});
    joinAtSeam(flat, 0.0);
    EXPECT_EQ(flat.contacts[1].id, 2);
    auto untracked = frameOf({partAt(0, 0.0, 11.5 * kPitch_m, 3.0), partAt(0, 0.0, -11.5 * kPitch_m, 1.0)});
    joinAtSeam(untracked, kAround_m);
    EXPECT_TRUE(untracked.features.cocX_m);
}

TEST(Seam, aThirdContactKeepsItsIdentityAndTheFrameHasNoCentre) {
    auto frame = frameOf({partAt(3, 0.0, 11.5 * kPitch_m, 3.0), partAt(2, 0.0, -11.5 * kPitch_m, 2.0),
                          partAt(1, 0.0, 0.0, 1.0)});
    joinAtSeam(frame, kAround_m);
    EXPECT_EQ(frame.contacts[0].id, 2);
    EXPECT_EQ(frame.contacts[1].id, 2);
    EXPECT_EQ(frame.contacts[2].id, 1);
    EXPECT_FALSE(frame.features.copX_m || frame.features.copY_m);
}
