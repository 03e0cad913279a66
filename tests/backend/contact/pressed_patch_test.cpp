// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/pressed_patch.h"
#include "backend/core/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

using namespace teleta::contact;

namespace {

constexpr int kTaxels = 11;

/// Part of a pressure on the left of a place, in half widths from its centre.
using Profile = std::function<double(double)>;

double even(double z) {
    return 0.5 + 0.5 * std::clamp(z, -1.0, 1.0);
}

/// The middle line of a ball on a bed of springs.
double ball(double z) {
    const double c = std::clamp(z, -1.0, 1.0);
    return 0.5 + 0.75 * (c - c * c * c / 3.0);
}

/// The middle line of a ball on an elastic half-space (Hertz).
double hertz(double z) {
    const double c = std::clamp(z, -1.0, 1.0);
    return 0.5 + (std::asin(c) + c * std::sqrt(1.0 - c * c)) / std::numbers::pi;
}

double cone(double z) {
    const double c = std::clamp(z, -1.0, 1.0);
    return 0.5 + c - 0.5 * c * std::abs(c);
}

/// A half width is two standard deviations.
double gauss(double z) {
    return 0.5 + 0.5 * std::erf(2.0 * z / std::numbers::sqrt2);
}

/// Loads of the taxels, each over its whole width, in shares of the highest.
std::vector<float> press(const Profile& profile, double centre, double halfWidth) {
    std::vector<double> load;
    for (int i = 0; i < kTaxels; ++i)
        load.push_back(profile((i + 0.5 - centre) / halfWidth) - profile((i - 0.5 - centre) / halfWidth));
    const double peak = *std::ranges::max_element(load);
    std::vector<float> shares;
    for (const double each : load)
        shares.push_back(static_cast<float>(each / peak));
    return shares;
}

} // namespace

TEST(PressedPatch, ofAnEvenPressureIsExactWhereverItIs) {
    for (const double centre : {4.5, 4.7, 5.0, 5.31, 5.49})
        for (const double halfWidth : {1.0, 1.2, 1.9, 3.1}) {
            const auto patch = pressedPatch(press(even, centre, halfWidth));
            ASSERT_TRUE(patch);
            EXPECT_NEAR(patch->centre, centre, 1e-6) << halfWidth;
            EXPECT_NEAR(patch->last - patch->first + 1 + patch->before + patch->after, 2.0 * halfWidth, 1e-6);
            EXPECT_NEAR(patch->misfit_N, 0.0, 1e-6);
        }
}

TEST(PressedPatch, ofASymmetricPressureIsItsMiddleOnATaxelAndBetweenTwo) {
    for (const Profile& profile : {Profile(ball), Profile(hertz), Profile(cone), Profile(gauss)})
        for (const double halfWidth : {0.75, 1.0, 1.7, 2.5})
            for (const double centre : {5.0, 5.5})
                EXPECT_NEAR(pressedPatch(press(profile, centre, halfWidth))->centre, centre, 1e-6);
}

TEST(PressedPatch, isMirroredWithTheLine) {
    std::vector<float> line = press(ball, 5.23, 1.4);
    const auto there = pressedPatch(line);
    std::ranges::reverse(line);
    const auto back = pressedPatch(line);
    ASSERT_TRUE(there && back);
    EXPECT_NEAR(there->centre, kTaxels - 1 - back->centre, 1e-12);
    EXPECT_NEAR(there->centreSe(0.01), back->centreSe(0.01), 1e-12);
}

TEST(PressedPatch, staysWhereItIsWhateverTheUnitOfTheLoads) {
    const std::vector<float> line = press(gauss, 4.8, 1.3);
    const auto unscaled = pressedPatch(line);
    for (const float scale : {1e-12F, 1e12F}) {
        std::vector<float> scaled;
        for (const float load : line)
            scaled.push_back(load * scale);
        EXPECT_NEAR(pressedPatch(scaled)->centre, unscaled->centre, 1e-6);
        EXPECT_NEAR(pressedPatch(scaled)->centreSe(0.01 * static_cast<double>(scale)),
                    unscaled->centreSe(0.01), 1e-6);
    }
}

TEST(PressedPatch, ofDegenerateLinesIsDefined) {
    EXPECT_FALSE(pressedPatch({}));
    EXPECT_FALSE(pressedPatch(std::vector<float>(5, 0.0F)));

    const auto one = pressedPatch(std::vector<float>{0, 0, 3, 0});
    EXPECT_EQ(one->centre, 2.0);
    // Anywhere on the taxel.
    EXPECT_NEAR(one->centreSe(1e-9), std::hypot(0.5 / std::sqrt(3.0), PressedPatch::kShapeSe), 1e-6);

    const auto alone = pressedPatch(std::vector<float>{3});
    EXPECT_EQ(alone->centre, 0.0);
    EXPECT_EQ(alone->load_N, 3.0);

    const auto plateau = pressedPatch(std::vector<float>{0, 2, 2, 2, 0});
    EXPECT_EQ(plateau->centre, 2.0);
    EXPECT_EQ(plateau->first, 1);
    EXPECT_EQ(plateau->last, 3);

    const auto full = pressedPatch(std::vector<float>(4, 2.0F));
    EXPECT_EQ(full->centre, 1.5);
    EXPECT_EQ(full->first, 0);
    EXPECT_EQ(full->last, 3);

    // A plateau of a saturated sensor between two edges, by hand: 1/4 before, 3/4 behind.
    EXPECT_NEAR(pressedPatch(std::vector<float>{0, 1, 4, 4, 3, 0})->centre, 2.5 + 0.25, 1e-12);
}

TEST(PressedPatch, standardErrorIsThatOfTheFormula) {
    // Loads 1, 4, 2 with noise 0.4: 0.1 of the load; before 1/4, after 1/2.
    const auto patch = pressedPatch(std::vector<float>{0, 1, 4, 2, 0});
    EXPECT_NEAR(patch->centre, 2.0 + 0.125, 1e-12);
    const double noise = 0.25 * 0.01 * (2.0 + 0.0625);
    EXPECT_NEAR(patch->centreSe(0.4), std::sqrt(noise + 0.05 * 0.05), 1e-12);
    // Scatter of the covered taxels counts where it is more than the noise.
    EXPECT_GT(pressedPatch(std::vector<float>{0, 3, 4, 5, 4, 0})->centreSe(1e-9), 0.06);
}

// The statement of kShapeSe: 92 % and more are within 1.96 standard errors, whatever the profile.
TEST(PressedPatch, standardErrorHoldsTheCentreOfAnyProfile) {
    teleta::core::RandomStream random(1, "pressed patch test");
    constexpr int kCases = 500;
    for (const double noise : {0.003, 0.02})
        for (const Profile& profile :
             {Profile(even), Profile(ball), Profile(hertz), Profile(cone), Profile(gauss)})
            for (const double halfWidth : {0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5}) {
                int held = 0;
                double width = 0.0;
                for (int i = 0; i < kCases; ++i) {
                    const double centre = 4.5 + random.uniform();
                    std::vector<float> line = press(profile, centre, halfWidth);
                    for (float& load : line)
                        load = std::max(0.0F, load + static_cast<float>(noise * random.normal()));
                    const auto patch = pressedPatch(line);
                    ASSERT_TRUE(patch);
                    const double se = patch->centreSe(noise);
                    held += std::abs(patch->centre - centre) <= 1.96 * se ? 1 : 0;
                    width += se / kCases;
                }
                EXPECT_GE(held, 0.92 * kCases) << "half width " << halfWidth << ", noise " << noise;
                EXPECT_LE(width, 0.3);
            }
}
