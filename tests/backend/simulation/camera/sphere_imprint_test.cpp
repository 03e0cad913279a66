// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/skin/sphere_imprint.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::simulation {
namespace {

constexpr double kRadius_m = 0.01;
constexpr double kDepth_m = 0.0015;
constexpr double kReach_m = 0.0015;

} // namespace

TEST(SphereImprint, isTheBallInTheContactAndTheMembranesEquationBesideIt) {
    const SphereImprint imprint(kRadius_m, kDepth_m, kReach_m);
    const double a_m = imprint.contactRadius_m();
    ASSERT_GT(a_m, 0.0);
    EXPECT_NEAR(imprint.depth_m(0.5 * a_m), kDepth_m - 0.25 * a_m * a_m / (2.0 * kRadius_m), 1e-12);
    // l^2 (w'' + w' / s) = w by central differences.
    for (const double s_m : {1.3 * a_m, 1.8 * a_m, 2.5 * a_m}) {
        const double h_m = 5e-5;
        const double before_m = imprint.depth_m(s_m - h_m);
        const double here_m = imprint.depth_m(s_m);
        const double after_m = imprint.depth_m(s_m + h_m);
        const double laplacian =
            (before_m - 2.0 * here_m + after_m) / (h_m * h_m) + (after_m - before_m) / (2.0 * h_m * s_m);
        EXPECT_NEAR(kReach_m * kReach_m * laplacian / here_m, 1.0, 0.01) << s_m;
    }
}

TEST(SphereImprint, hasNeitherStepNorKinkAtTheRimOfTheContact) {
    const SphereImprint imprint(kRadius_m, kDepth_m, kReach_m);
    const double a_m = imprint.contactRadius_m();
    const double h_m = 2e-5;
    EXPECT_NEAR(imprint.depth_m(a_m - 1e-9), imprint.depth_m(a_m + 1e-9), 1e-8);
    const double inside = (imprint.depth_m(a_m) - imprint.depth_m(a_m - h_m)) / h_m;
    const double outside = (imprint.depth_m(a_m + h_m) - imprint.depth_m(a_m)) / h_m;
    EXPECT_NEAR(outside, inside, 0.02 * std::abs(inside));
}

TEST(SphereImprint, growsWithTheDepthAndVanishesWithIt) {
    double before_m = 0.0;
    for (double depth_m = 1e-5; depth_m < 5e-3; depth_m *= 1.5) {
        const SphereImprint imprint(kRadius_m, depth_m, kReach_m);
        EXPECT_GT(imprint.contactRadius_m(), before_m);
        EXPECT_LT(imprint.contactRadius_m(), std::sqrt(2.0 * kRadius_m * depth_m));
        EXPECT_EQ(imprint.depth_m(imprint.influence_m() + 1e-9), 0.0);
        before_m = imprint.contactRadius_m();
    }
    for (const double depth_m : {0.0, -0.001, 1e-12}) {
        const SphereImprint none(kRadius_m, depth_m, kReach_m);
        EXPECT_EQ(none.depth_m(0.0), 0.0);
        EXPECT_EQ(none.dragShare(0.0), 0.0);
        EXPECT_EQ(none.contactRadius_m(), 0.0);
    }
}

} // namespace teleta::simulation
