// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/gel/gel_camera.h"
#include "backend/simulation/camera/gel/gel_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace teleta::simulation {
namespace {

/// A ball of 25 mm that is 1.6 mm deep after 0.2 s and is dragged along x from then on.
scene::Scene dragged(double drag_m, double turn_rad = 0.0) {
    scene::Scene scene;
    scene.name = "dragged";
    scene.duration_s = 1.0;
    scene.rate_Hz = 20.0;
    scene::GelWorld world;
    world.balls.push_back(
        {.name = "ball",
         .x_m = 0.016,
         .y_m = 0.012,
         .radius_m = 0.025,
         .friction = 0.5,
         .spreadPerDepth = 0.0,
         .keyframes = {{.time_s = 0.0, .depth_m = -0.001},
                       {.time_s = 0.2, .depth_m = 0.0016},
                       {.time_s = 0.8, .depth_m = 0.0016, .dragX_m = drag_m, .turn_rad = turn_rad}}});
    scene.world = world;
    return scene;
}

std::unique_ptr<GelStage> atEnd(const scene::Scene& scene) {
    auto stage = GelStage::make(scene, 1);
    EXPECT_TRUE(stage);
    cv::Mat1b picture;
    for (int i = 0; i < 20; ++i)
        (*stage)->next(picture);
    return std::move(*stage);
}

/// How far the marker that is nearest to a place at rest has moved, in m; pixels are 0.1 mm.
Eigen::Vector2d moved_m(const GelStage& stage, const Eigen::Vector2d& place_m) {
    const auto near = std::ranges::min_element(stage.rest_px(), {}, [&](const Eigen::Vector2d& rest) {
        return (1e-4 * rest - place_m).squaredNorm();
    });
    return 1e-4 * (stage.places_px()[static_cast<std::size_t>(near - stage.rest_px().begin())] - *near);
}

} // namespace

TEST(GelStage, theContactIsThatOfHertz) {
    const auto stage = atEnd(dragged(0.0));
    ASSERT_EQ(stage->truth().size(), 1U);
    EXPECT_TRUE(stage->truth()[0].touches);
    // sqrt(25 mm x 1.6 mm)
    EXPECT_NEAR(stage->truth()[0].radius_m, 0.006324555, 1e-9);
    EXPECT_EQ(stage->truth()[0].slipShare, 0.0);
    EXPECT_EQ(moved_m(*stage, {0.016, 0.012}).norm(), 0.0);
}

TEST(GelStage, whatSticksMovesWithTheBallUntilAllSlips) {
    // All slips once the ball has gone friction x depth = 0.8 mm; a half of it: c / a = sqrt(1 / 2), and what
    // sticks, 4.5 mm about the centre, moves by 0.4 mm.
    const auto half = atEnd(dragged(0.0004));
    EXPECT_NEAR(half->truth()[0].slipShare, 0.5, 1e-12);
    EXPECT_NEAR(moved_m(*half, {0.016, 0.012}).x(), 0.0004, 1e-12);
    EXPECT_NEAR(moved_m(*half, {0.019, 0.012}).x(), 0.0004, 1e-12);
    EXPECT_LT(moved_m(*half, {0.028, 0.012}).x(), 0.0003);
    const auto whole = atEnd(dragged(0.0020));
    EXPECT_EQ(whole->truth()[0].slipShare, 1.0);
    // The ball has gone on by 1.2 mm without the skin.
    EXPECT_NEAR(whole->truth()[0].centre_m.x(), 0.0172, 1e-12);
    EXPECT_LE(moved_m(*whole, {0.017, 0.012}).x(), 0.0008);
}

TEST(GelStage, theSkinUnderATwistedBallTurnsWithIt) {
    const auto stage = atEnd(dragged(0.0, 0.1));
    // A marker 3 mm from the centre, from the picture's own places.
    const auto near = std::ranges::min_element(stage->rest_px(), {}, [](const Eigen::Vector2d& rest) {
        return (rest - Eigen::Vector2d(190.0, 120.0)).squaredNorm();
    });
    const Eigen::Vector2d from_px = *near - Eigen::Vector2d(160.0, 120.0);
    ASSERT_LT(from_px.norm(), 63.0);
    const Eigen::Vector2d to_px = from_px + 1e4 * moved_m(*stage, 1e-4 * *near);
    EXPECT_NEAR(std::atan2(to_px.y(), to_px.x()) - std::atan2(from_px.y(), from_px.x()), 0.1, 1e-9);
}

TEST(GelStage, isDeterministicAndRefusesOtherScenes) {
    cv::Mat1b first, second;
    const auto one = GelStage::make(dragged(0.0004), 3);
    const auto two = GelStage::make(dragged(0.0004), 3);
    ASSERT_TRUE(one && two);
    for (int i = 0; i < 5; ++i) {
        (*one)->next(first);
        (*two)->next(second);
    }
    EXPECT_EQ(cv::norm(first, second, cv::NORM_L1), 0.0);
    EXPECT_FALSE(GelStage::make(scene::Scene{}, 1));
}

TEST(GelCamera, startsAnewAtTheEndAndStandsStillWhileHeld) {
    const auto made = makeGelCamera(dragged(0.0004), 1);
    ASSERT_TRUE(made);
    core::CameraGenerator& camera = **made;
    EXPECT_TRUE(camera.description().simulated);
    core::GreyImage image;
    for (int i = 0; i < 20; ++i)
        EXPECT_FALSE(camera.next(image, false));
    EXPECT_FALSE(camera.next(image, true));
    EXPECT_TRUE(camera.next(image, false));
    EXPECT_FALSE(camera.next(image, false));
    EXPECT_EQ(image.width_px, 320);
    EXPECT_NEAR(camera.time_s(), 23.0 / 20.0, 1e-12);
}

} // namespace teleta::simulation
