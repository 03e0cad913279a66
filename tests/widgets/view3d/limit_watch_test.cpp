// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/limit_watch.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

using teleta::view3d::LimitWatch;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

bool update(LimitWatch& watch, double angle_deg, double lowest_deg, double highest_deg) {
    return watch.update(angle_deg * kDegree, lowest_deg * kDegree, highest_deg * kDegree);
}

} // namespace

TEST(LimitWatch, aLongRangeIsNearItsEndsWithinTenDegrees) {
    LimitWatch watch;
    EXPECT_FALSE(update(watch, 159.9, -170.0, 170.0));
    EXPECT_TRUE(update(watch, 160.1, -170.0, 170.0));
    EXPECT_FALSE(update(watch, 0.0, -170.0, 170.0));
    EXPECT_TRUE(update(watch, -160.1, -170.0, 170.0));
}

TEST(LimitWatch, aShortRangeWithinATenthOfIt) {
    LimitWatch watch;
    EXPECT_FALSE(update(watch, 35.9, 0.0, 40.0));
    EXPECT_TRUE(update(watch, 36.1, 0.0, 40.0));
}

TEST(LimitWatch, itIsLeftHalfAsFarAgain) {
    LimitWatch watch;
    EXPECT_TRUE(update(watch, 161.0, -170.0, 170.0));
    EXPECT_TRUE(update(watch, 155.1, -170.0, 170.0));
    EXPECT_FALSE(update(watch, 154.9, -170.0, 170.0));
    EXPECT_FALSE(update(watch, 159.0, -170.0, 170.0));
}

TEST(LimitWatch, beyondTheEndIsNear) {
    LimitWatch watch;
    EXPECT_TRUE(update(watch, 172.0, -170.0, 170.0));
}

TEST(LimitWatch, aJointWithoutLimitsOrAnAngleHasNoEnd) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    LimitWatch watch;
    EXPECT_FALSE(watch.update(3.0, -kInfinity, kInfinity));
    EXPECT_FALSE(watch.update(3.0, 0.0, kInfinity));
    EXPECT_FALSE(watch.update(0.0, 0.0, 0.0));
    EXPECT_FALSE(watch.update(0.5, 1.0, 0.0));
    EXPECT_TRUE(watch.update(1.0, 0.0, 1.0));
    EXPECT_FALSE(watch.update(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0));
}
