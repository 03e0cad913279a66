// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/gel_bumps.h"

#include <gtest/gtest.h>

#include <numbers>

namespace teleta::vision {
namespace {

constexpr double kRadius_m = 0.005;
constexpr double kPeriod_s = 0.02;
constexpr double kNoise_m = 1e-6;

/// A round contact whose rim is pressed outwards by spread: 2 pi a spread flows out of pi a^2.
GelContactState pressed(int id, double spread_m) {
    GelContactState contact;
    contact.id = id;
    contact.area_m2 = std::numbers::pi * kRadius_m * kRadius_m;
    contact.normalProxy_m2 = 2.0 * std::numbers::pi * kRadius_m * spread_m;
    return contact;
}

} // namespace

TEST(GelBumps, theSpreadIsThatOfTheRim) {
    EXPECT_NEAR(spreadOf_m(pressed(1, 0.0003)), 0.0003, 1e-15);
    EXPECT_EQ(spreadOf_m(GelContactState()), 0.0);
}

TEST(GelBumps, aContactThatSpreadsTheSkinQuicklyIsOne) {
    const auto firstBump = [](double speed_mPerS) {
        GelBumps bumps({.speed_mPerS = 0.002, .depth_m = 1.0});
        for (int i = 1; i <= 20; ++i) {
            const auto bump =
                bumps.next({pressed(7, speed_mPerS * kPeriod_s * i)}, kPeriod_s * i, kPeriod_s, kNoise_m);
            if (!bump)
                continue;
            EXPECT_EQ(bump->contact, 7);
            EXPECT_EQ(bump->retreat, -Eigen::Vector3d::UnitZ());
            return i;
        }
        return 0;
    };
    EXPECT_EQ(firstBump(0.0015), 0);
    EXPECT_EQ(firstBump(0.003), 2) << "the second picture tells a speed";
}

TEST(GelBumps, aDeepContactIsOneOnceAndAnewAfterItHasEnded) {
    GelBumps bumps({.speed_mPerS = 1.0, .depth_m = 0.0002});
    double time_s = 0.0;
    const auto isBump = [&](const std::vector<GelContactState>& contacts) {
        time_s += kPeriod_s;
        return bumps.next(contacts, time_s, kPeriod_s, kNoise_m).has_value();
    };
    EXPECT_FALSE(isBump({pressed(1, 0.0001)}));
    EXPECT_TRUE(isBump({pressed(1, 0.0003)}));
    EXPECT_FALSE(isBump({pressed(1, 0.0004)}));
    EXPECT_FALSE(isBump({}));
    EXPECT_TRUE(isBump({pressed(2, 0.0003)}));
}

} // namespace teleta::vision
