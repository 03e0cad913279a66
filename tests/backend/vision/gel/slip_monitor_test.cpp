// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/vision/gel/slip_monitor.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace teleta::vision {
namespace {

constexpr double kNoise_m = 5e-6;

/// A grid of 5 x 5 that turns and moves as one; the first `slipping` stay behind.
std::vector<ContactPlace> moved(std::size_t slipping, double turn_rad, const Eigen::Vector2d& by_m) {
    std::vector<ContactPlace> places;
    core::RandomStream random(4);
    const Eigen::Rotation2Dd turn(turn_rad);
    for (std::size_t i = 0; i < 25; ++i) {
        const Eigen::Vector2d rest(0.002 * static_cast<double>(i % 5), 0.002 * static_cast<double>(i / 5));
        Eigen::Vector2d moved_m = turn * rest + by_m - rest;
        if (i < slipping)
            moved_m *= 0.2 + 0.02 * static_cast<double>(i);
        moved_m += kNoise_m * Eigen::Vector2d(random.normal(), random.normal());
        places.push_back({.rest_m = rest, .moved_m = moved_m});
    }
    return places;
}

const Eigen::Vector2d kShear_m(0.0004, 0.0);

} // namespace

TEST(SharedMotion, isWhatMostPlacesDo) {
    for (const std::size_t slipping : {0U, 5U, 10U}) {
        const auto motion = sharedMotion(moved(slipping, 0.1, {0.001, -0.0005}), kNoise_m);
        ASSERT_TRUE(motion);
        EXPECT_EQ(motion->sticking, 25U - slipping);
        EXPECT_NEAR(motion->turn_rad, 0.1, 0.005);
        for (std::size_t i = 0; i < 25; ++i)
            EXPECT_EQ(motion->sticks[i], i >= slipping) << i;
    }
}

TEST(SharedMotion, isUndefinedUnderFivePlaces) {
    auto places = moved(0, 0.0, {0.001, 0.0});
    places.resize(4);
    EXPECT_FALSE(sharedMotion(places, kNoise_m));
    EXPECT_FALSE(sharedMotion({}, kNoise_m));
    // Five times the same place propose nothing.
    EXPECT_FALSE(sharedMotion(std::vector<ContactPlace>(5), kNoise_m));
}

TEST(SlipMonitor, tellsIncipientSlipAndSlipAfterTwoFrames) {
    SlipMonitor monitor;
    const auto next = [&](double index) { return monitor.next(index, kShear_m, {0.0, 0.0}, kNoise_m); };
    EXPECT_EQ(next(0.1), SlipEvent::none);
    EXPECT_EQ(next(0.35), SlipEvent::none);
    EXPECT_EQ(next(0.1), SlipEvent::none); // one frame alone
    EXPECT_EQ(next(0.35), SlipEvent::none);
    EXPECT_EQ(next(0.4), SlipEvent::incipientSlip);
    EXPECT_EQ(next(0.5), SlipEvent::none); // once
    EXPECT_EQ(next(0.85), SlipEvent::none);
    EXPECT_EQ(next(0.9), SlipEvent::slip);
    EXPECT_EQ(next(0.9), SlipEvent::none);
    EXPECT_EQ(next(0.1), SlipEvent::none);
    EXPECT_EQ(next(0.9), SlipEvent::none);
    EXPECT_EQ(next(0.9), SlipEvent::slip); // the next one
}

TEST(SlipMonitor, tellsThatTheShearFellWhileTheRimMovedOn) {
    SlipMonitor monitor;
    const Eigen::Vector2d on(0.00003, 0.0);
    EXPECT_EQ(monitor.next(0.0, kShear_m, on, kNoise_m), SlipEvent::none);
    EXPECT_EQ(monitor.next(0.0, 0.9 * kShear_m, on, kNoise_m), SlipEvent::none);
    EXPECT_EQ(monitor.next(0.0, 0.7 * kShear_m, on, kNoise_m), SlipEvent::slip);
    // Where the load is taken away the rim goes back.
    SlipMonitor released;
    EXPECT_EQ(released.next(0.0, kShear_m, on, kNoise_m), SlipEvent::none);
    EXPECT_EQ(released.next(0.0, 0.7 * kShear_m, -on, kNoise_m), SlipEvent::none);
}

TEST(SlipMonitor, saysNothingOfAnUndefinedIndex) {
    SlipMonitor monitor;
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(monitor.next(std::nullopt, {0.0, 0.0}, {0.0, 0.0}, kNoise_m), SlipEvent::none);
}

} // namespace teleta::vision
