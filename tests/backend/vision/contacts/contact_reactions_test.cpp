// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/contact_reactions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace teleta::vision {
namespace {

FollowedContact contact(int id, double angle_rad, double depth_m, double rate_mPerS) {
    FollowedContact followed;
    followed.contact.id = id;
    followed.contact.depth_m = depth_m;
    followed.contact.p_Sensor_Centre_m = {0.025 * std::cos(angle_rad), 0.025 * std::sin(angle_rad), 0.05};
    constexpr double kPeriod_s = 0.025;
    followed.contact.deepened_m = rate_mPerS * kPeriod_s;
    followed.depthRate.add(followed.contact, kPeriod_s, kPeriod_s);
    followed.seen = true;
    return followed;
}

Eigen::Vector3d place(double angle_rad, double z_m) {
    return {0.025 * std::cos(angle_rad), 0.025 * std::sin(angle_rad), z_m};
}

} // namespace

TEST(BumpDetector, seesAFastContactAndADeepOneAndNoOther) {
    BumpDetector detector({.speed_mPerS = 0.02, .depth_m = 0.0015});
    EXPECT_FALSE(detector.update(std::vector{contact(1, 0.0, 0.001, 0.01)}));
    EXPECT_TRUE(detector.update(std::vector{contact(2, 0.0, 0.001, 0.03)}));
    EXPECT_TRUE(detector.update(std::vector{contact(3, 0.0, 0.0016, 0.0)}));
}

TEST(BumpDetector, drawsBackAlongTheInwardNormalThroughTheAxis) {
    BumpDetector detector;
    const auto bump = detector.update(std::vector{contact(1, 2.0, 0.002, 0.0)});
    ASSERT_TRUE(bump);
    EXPECT_NEAR(bump->retreat.x(), -std::cos(2.0), 1e-12);
    EXPECT_NEAR(bump->retreat.y(), -std::sin(2.0), 1e-12);
    EXPECT_EQ(bump->retreat.z(), 0.0);
}

TEST(BumpDetector, countsEachContactOnceAndTakesTheDeepestOfSeveral) {
    BumpDetector detector;
    const std::vector both{contact(1, 0.0, 0.002, 0.0), contact(2, 1.0, 0.003, 0.0)};
    EXPECT_EQ(detector.update(both)->contact, 2);
    EXPECT_EQ(detector.update(both)->contact, 1);
    EXPECT_FALSE(detector.update(both));
}

TEST(BumpDetector, saysNothingOfAContactThatWasNotSeen) {
    BumpDetector detector;
    FollowedContact unseen = contact(1, 0.0, 0.002, 0.0);
    unseen.seen = false;
    EXPECT_FALSE(detector.update(std::vector{unseen}));
    EXPECT_FALSE(detector.update(std::vector{contact(1, 0.0, NAN, NAN)}));
}

TEST(FollowMotion, isTheTurnAndTheWayAlongTheTubeOfAMixedMotion) {
    const FollowMotion motion = followMotion(place(3.0, 0.03), place(3.0 + 0.5, 0.042));
    EXPECT_NEAR(motion.turn_rad, 0.5, 1e-12); // across the seam of the angle
    EXPECT_NEAR(motion.along_m, 0.012, 1e-12);
    const FollowMotion back = followMotion(place(0.2, 0.03), place(-0.1, 0.03));
    EXPECT_NEAR(back.turn_rad, -0.3, 1e-12);
    EXPECT_EQ(back.along_m, 0.0);
}

TEST(FollowMotion, isNoTurnForAPlaceOnTheAxis) {
    EXPECT_EQ(followMotion({0.0, 0.0, 0.01}, place(1.0, 0.02)).turn_rad, 0.0);
}

} // namespace teleta::vision
