// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/laws.h"
#include "backend/pattern/model/parametric_object.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

using namespace teleta::pattern;
using teleta::core::Intensities;

namespace {

double energy(const Intensities& intensities) {
    return std::inner_product(intensities.begin(), intensities.end(), intensities.begin(), 0.0);
}

constexpr double kSixth_rad = std::numbers::pi / 3.0;

} // namespace

TEST(Laws, apparentMotionOnsetIsThatOfTheFormula) {
    EXPECT_DOUBLE_EQ(apparentMotionOnset_s(0.0), 0.0473);
    EXPECT_DOUBLE_EQ(apparentMotionOnset_s(0.1), 0.0793);
}

TEST(Laws, burstsOfARingInTwoSecondsAreThoseOfTheTable) {
    EXPECT_NEAR(*ringBurst_s(3, 2.0), 0.1994, 5e-5);
    EXPECT_NEAR(*ringBurst_s(4, 2.0), 0.1126, 5e-5);
    EXPECT_NEAR(*ringBurst_s(5, 2.0), 0.0605, 5e-5);
}

TEST(Laws, ringWithTooManyTurnsHasNoBurst) {
    EXPECT_TRUE(ringBurst_s(7, 2.0)); // onsets 47.6 ms apart
    EXPECT_FALSE(ringBurst_s(8, 2.0));
    EXPECT_FALSE(ringBurst_s(0, 2.0));
    EXPECT_FALSE(ringBurst_s(-1, 2.0));
    EXPECT_FALSE(ringBurst_s(1, std::nan("")));
}

TEST(Laws, phantomKeepsTheEnergy) {
    for (const double b : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const auto [first, second] = phantomIntensities(b, 0.8);
        EXPECT_DOUBLE_EQ(first, 0.8 * std::sqrt(1.0 - b));
        EXPECT_DOUBLE_EQ(second, 0.8 * std::sqrt(b));
        EXPECT_NEAR(first * first + second * second, 0.64, 1e-15);
    }
    EXPECT_EQ(phantomIntensities(std::nan(""), 1.0), (std::pair{0.0, 0.0}));
}

TEST(Sweep, burstsFollowOneAnotherByTheLawOfApparentMotion) {
    const Sweep sweep{1.0, 0.1, std::nullopt, {4, 2}, 0.7};
    EXPECT_EQ(evaluate(sweep, 0.999), Intensities{});
    EXPECT_EQ(evaluate(sweep, 1.0), (Intensities{0, 0, 0, 0, 0.7, 0}));
    EXPECT_EQ(evaluate(sweep, 1.08), (Intensities{0, 0, 0.7, 0, 0.7, 0})); // second from 79.3 ms on
    EXPECT_EQ(evaluate(sweep, 1.11), (Intensities{0, 0, 0.7, 0, 0, 0}));
    EXPECT_EQ(evaluate(sweep, 1.1794), Intensities{});
    EXPECT_NEAR(spanOf(ObjectForm(sweep)).end_s, 1.1793, 1e-12);
}

TEST(Ring, ofFiveTurnsLightsEveryTactorFiveTimesInTwoSeconds) {
    const Ring ring{0.0, 2.0, 5, 0, true, std::nullopt, 1.0};
    std::array<int, 6> starts{};
    Intensities before{};
    std::vector<std::size_t> order;
    for (int k = 0; k < 2000; ++k) {
        const Intensities now = evaluate(ring, 0.001 * k + 1e-6);
        for (std::size_t i = 0; i < 6; ++i) {
            if (now[i] > 0.0 && before[i] == 0.0) {
                ++starts[i];
                order.push_back(i);
            }
        }
        before = now;
    }
    EXPECT_EQ(starts, (std::array{5, 5, 5, 5, 5, 5}));
    for (std::size_t k = 0; k < order.size(); ++k)
        EXPECT_EQ(order[k], k % 6);
    EXPECT_EQ(evaluate(ring, 2.0), Intensities{});
}

TEST(Ring, clockwiseGoesDownFromTheFirstTactor) {
    const Ring ring{0.0, 0.6, 1, 2, false, 0.1, 1.0};
    const std::array<std::size_t, 6> order{2, 1, 0, 5, 4, 3};
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_EQ(evaluate(ring, 0.05 + 0.1 * static_cast<double>(k))[order[k]], 1.0);
}

TEST(Phantom, movesFromOneTactorToTheOther) {
    const Phantom phantom{0.0, 2.0, 1, 2, 0.0, 1.0, 1.0};
    EXPECT_EQ(evaluate(phantom, 0.0), (Intensities{0, 1, 0, 0, 0, 0}));
    EXPECT_NEAR(evaluate(phantom, 0.5)[1], std::sqrt(0.75), 1e-15);
    EXPECT_NEAR(evaluate(phantom, 0.5)[2], 0.5, 1e-15);
}

TEST(PulseTrain, isOnForItsWidthInEveryPeriod) {
    const PulseTrain train{0.1, 1.0, 0.25, 0.05, {0, 3}, 0.6};
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(evaluate(train, 0.12 + 0.25 * k), (Intensities{0.6, 0, 0, 0.6, 0, 0}));
        EXPECT_EQ(evaluate(train, 0.16 + 0.25 * k), Intensities{});
    }
    EXPECT_EQ(evaluate(train, 1.11), Intensities{});
}

TEST(Stroke, isFeltAtATactorWhenItPassesOverIt) {
    for (int i = 0; i < 6; ++i) {
        const Intensities intensities = strokeIntensities(i * kSixth_rad, i % 2, 0.9);
        for (int j = 0; j < 6; ++j)
            EXPECT_NEAR(intensities[static_cast<std::size_t>(j)], i == j ? 0.9 : 0.0, 1e-7) << i << ' ' << j;
    }
}

TEST(Stroke, betweenTwoNeighboursIsTheirPhantom) {
    // The straight way from tactor 1 (odd row) to tactor 2 (even row).
    for (const double b : {0.2, 0.5, 0.75}) {
        const Intensities intensities = strokeIntensities((1.0 + b) * kSixth_rad, 1.0 - b, 1.0);
        EXPECT_NEAR(intensities[1], std::sqrt(1.0 - b), 1e-7);
        EXPECT_NEAR(intensities[2], std::sqrt(b), 1e-7);
    }
}

TEST(Stroke, alongTheRowIsThePhantomOfEverySecondTactor) {
    const Intensities intensities = strokeIntensities(0.5 * kSixth_rad, 0.0, 1.0); // a quarter from 0 to 2
    EXPECT_NEAR(intensities[0], std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(intensities[2], 0.5, 1e-12);
    EXPECT_NEAR(intensities[1], 0.0, 1e-7);
}

TEST(Stroke, keepsTheEnergyEverywhereAndTurnsWithTheRing) {
    for (int k = 0; k < 97; ++k) {
        for (const double along : {-0.5, 0.0, 0.2, 0.5, 0.9, 1.0, 3.0}) {
            const double angle_rad = -7.0 + 0.21 * k;
            const Intensities here = strokeIntensities(angle_rad, along, 0.5);
            EXPECT_NEAR(energy(here), 0.25, 1e-12);
            const Intensities twoFurther = strokeIntensities(angle_rad + 2.0 * kSixth_rad, along, 0.5);
            for (std::size_t i = 0; i < 6; ++i)
                EXPECT_NEAR(here[i], twoFurther[(i + 2) % 6], 1e-6);
        }
    }
}

TEST(Stroke, goesRoundMoreThanOnce) {
    const Stroke stroke{0.0, {{0.0, 0.0, 0.0}, {2.0, 4.0 * std::numbers::pi, 0.0}}, 1.0};
    EXPECT_NEAR(evaluate(stroke, 1.0 / 3.0)[2], 1.0, 1e-7);
    EXPECT_NEAR(evaluate(stroke, 4.0 / 3.0)[2], 1.0, 1e-7);
    EXPECT_EQ(evaluate(stroke, 2.0), Intensities{});
}
