// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/vision/gel/slip_ring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace teleta::vision {
namespace {

constexpr double kRadius_m = 0.006;
constexpr double kNoise_m = 3.5e-6;
const Eigen::Vector2d kCentre_m(0.010, 0.008);

/// Places 2 mm apart in and around a contact of which this share slips, on a way of 0.45 mm until all does.
std::vector<ContactPlace> dragged(double share, double noise_m, double turn_rad = 0.0) {
    const simulation::GelContact ball{.centre_m = kCentre_m,
                                      .radius_m = kRadius_m,
                                      .slip_m = {3e-4, 3.354e-4},
                                      .stick = std::sqrt(1.0 - share)};
    core::RandomStream random(11);
    std::vector<ContactPlace> places;
    for (int row = -5; row <= 5; ++row)
        for (int column = -5; column <= 5; ++column) {
            const Eigen::Vector2d rest_m =
                kCentre_m + Eigen::Vector2d(0.002 * column + 3e-4, 0.002 * row - 2e-4);
            const Eigen::Vector2d off_m = rest_m - kCentre_m;
            places.push_back({.rest_m = rest_m,
                              .moved_m = ball.displacement_m(rest_m) +
                                         turn_rad * Eigen::Vector2d(-off_m.y(), off_m.x()) +
                                         noise_m * Eigen::Vector2d(random.normal(), random.normal())});
        }
    return places;
}

} // namespace

TEST(SlippingRing, isTheShareOfTheLawWithoutNoise) {
    for (const double share : {0.2, 0.3, 0.5, 0.7, 0.9, 1.0}) {
        const auto found = slippingRing(dragged(share, 0.0), kCentre_m, kRadius_m, 0.03 * kNoise_m);
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, share, 0.021) << "a step of the search";
    }
}

TEST(SlippingRing, needsTheRadiusToTenPercentOnly) {
    for (const double factor : {0.9, 1.1})
        for (const double share : {0.5, 0.7, 0.9}) {
            const auto found =
                slippingRing(dragged(share, kNoise_m), kCentre_m, factor * kRadius_m, kNoise_m);
            ASSERT_TRUE(found);
            EXPECT_NEAR(*found, share, 0.1) << factor << ' ' << share;
        }
}

TEST(SlippingRing, takesNeitherATurnNorNoiseForSlip) {
    for (const double turn_rad : {0.0, 0.03}) {
        const auto found = slippingRing(dragged(0.02, kNoise_m, turn_rad), kCentre_m, kRadius_m, kNoise_m);
        ASSERT_TRUE(found);
        EXPECT_EQ(*found, 0.0) << turn_rad;
    }
    const auto turned = slippingRing(dragged(0.6, 0.0, 0.03), kCentre_m, kRadius_m, kNoise_m);
    ASSERT_TRUE(turned);
    EXPECT_NEAR(*turned, 0.6, 0.05);
}

TEST(SlippingRing, isNoneUntilItStandsOutOfTheNoise) {
    double before = 0.0;
    for (const double share : {0.1, 0.3, 0.5}) {
        const auto found = slippingRing(dragged(share, 0.0), kCentre_m, kRadius_m, 3.0 * kNoise_m);
        ASSERT_TRUE(found);
        EXPECT_LT(*found, share + 0.021) << "too little, if anything";
        EXPECT_GE(*found, before);
        before = *found;
    }
    EXPECT_EQ(slippingRing(dragged(0.1, 0.0), kCentre_m, kRadius_m, 3.0 * kNoise_m), 0.0);
}

TEST(SlippingRing, isNothingWhereNoRingExplainsTheMotion) {
    std::vector<ContactPlace> torn = dragged(0.5, 0.0);
    for (std::size_t i = 0; i < torn.size(); i += 2)
        torn[i].moved_m *= 0.3;
    EXPECT_FALSE(slippingRing(torn, kCentre_m, kRadius_m, kNoise_m));
    EXPECT_FALSE(slippingRing({}, kCentre_m, kRadius_m, kNoise_m));
}

} // namespace teleta::vision
