// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/trail.h"

#include <gtest/gtest.h>

#include <limits>

using teleta::view3d::Trail;

namespace {

/// At a steady 0.1 m/s along x, from 0 on, every 20 ms.
Trail steady(double duration_s) {
    Trail trail;
    for (int i = 0; 0.02 * i <= duration_s + 1e-9; ++i)
        trail.add({0.1 * 0.02 * i, 0.0, 0.0}, 0.02 * i);
    return trail;
}

} // namespace

TEST(Trail, fadesEvenlyOverFiveSeconds) {
    const Trail trail = steady(4.0);
    ASSERT_EQ(trail.places().size(), 201U);
    EXPECT_DOUBLE_EQ(trail.shareLeft(trail.places().back()), 1.0);
    EXPECT_NEAR(trail.shareLeft(trail.places()[100]), 1.0 - 2.0 / 5.0, 1e-12);
    EXPECT_NEAR(trail.shareLeft(trail.places().front()), 1.0 - 4.0 / 5.0, 1e-12);
}

TEST(Trail, whatIsOlderIsForgotten) {
    const Trail trail = steady(60.0);
    EXPECT_LE(trail.places().size(), 251U);
    EXPECT_GE(trail.places().size(), 249U);
    EXPECT_GT(trail.shareLeft(trail.places().front()), 0.0);
    EXPECT_NEAR(trail.places().back().p_m.x(), 6.0, 1e-12);
}

TEST(Trail, anArmThatStandsStillLosesItsTrailAndKeepsItsPlace) {
    Trail trail = steady(1.0);
    for (int i = 1; i <= 400; ++i)
        trail.add({0.1, 0.0, 0.0}, 1.0 + 0.02 * i);
    EXPECT_LE(trail.places().size(), 2U);
    EXPECT_NEAR(trail.places().back().p_m.x(), 0.1, 1e-12);
    // A step that is smaller than those that are kept moves the end only.
    trail.add({0.1 + 0.4 * Trail::kStep_m, 0.0, 0.0}, 9.02);
    EXPECT_LE(trail.places().size(), 3U);
    EXPECT_NEAR(trail.places().back().p_m.x(), 0.1 + 0.4 * Trail::kStep_m, 1e-12);
}

TEST(Trail, slowMotionIsKeptInStepsAndNotInSamples) {
    Trail trail;
    // 1 mm in 1 s, by a thousand samples.
    for (int i = 0; i <= 1000; ++i)
        trail.add({1e-6 * i, 0.0, 0.0}, 1e-3 * i);
    EXPECT_LE(trail.places().size(), 5U);
    EXPECT_NEAR(trail.places().back().p_m.x(), 1e-3, 1e-12);
}

TEST(Trail, aTimeThatGoesBackOrAPauseBeginsAnew) {
    Trail trail = steady(1.0);
    trail.add({0.5, 0.0, 0.0}, 0.9);
    EXPECT_EQ(trail.places().size(), 1U);
    trail = steady(1.0);
    trail.add({0.5, 0.0, 0.0}, 1.0 + 1.01 * Trail::kGap_s);
    EXPECT_EQ(trail.places().size(), 1U);
    trail = steady(1.0);
    trail.add({0.5, 0.0, 0.0}, 1.0 + 0.99 * Trail::kGap_s);
    EXPECT_GT(trail.places().size(), 40U);
}

TEST(Trail, whatIsNotFiniteIsPassedOver) {
    Trail trail = steady(1.0);
    const std::size_t before = trail.places().size();
    trail.add({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, 1.02);
    trail.add({0.0, 0.0, 0.0}, std::numeric_limits<double>::infinity());
    EXPECT_EQ(trail.places().size(), before);
}
