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

TEST(GelStage, anArmMovesTheGelUnderTheBall) {
    const auto made = GelStage::make(dragged(0.0), 1);
    ASSERT_TRUE(made);
    GelStage& stage = **made;
    cv::Mat1b picture;
    for (int i = 0; i < 10; ++i)
        stage.next(picture);
    // Aside it is as if the ball were dragged the other way; all slips from 0.8 mm on.
    while (stage.arm().pose().aside_m.x() < 0.0004)
        stage.next({.aside_mPerS = {0.004, 0.0}}, picture);
    EXPECT_NEAR(stage.truth()[0].drag_m.x(), -stage.arm().pose().aside_m.x(), 1e-15);
    EXPECT_NEAR(stage.truth()[0].slipShare, stage.arm().pose().aside_m.x() / 0.0008, 1e-12);
    EXPECT_EQ(stage.truth()[0].centre_m, Eigen::Vector2d(0.016, 0.012));
    // Away from the ball it is pressed less, and not at all in the end.
    for (int i = 0; i < 2; ++i)
        stage.next({.along_mPerS = 0.004}, picture);
    const double away_m = stage.arm().pose().along_m;
    ASSERT_GT(away_m, 0.0);
    EXPECT_NEAR(stage.truth()[0].radius_m, std::sqrt(0.025 * (0.0016 - away_m)), 1e-12);
    for (int i = 0; i < 20; ++i)
        stage.next({.along_mPerS = 0.004}, picture);
    EXPECT_FALSE(stage.truth()[0].touches);
    // Then the ball meets the gel where the arm has brought it.
    const double aside_m = stage.arm().pose().aside_m.x();
    while (!stage.truth()[0].touches)
        stage.next({.along_mPerS = -0.004}, picture);
    EXPECT_NEAR(stage.truth()[0].centre_m.x(), 0.016 - aside_m, 1e-12);
    EXPECT_EQ(stage.truth()[0].drag_m.norm(), 0.0);
    stage.restart();
    EXPECT_EQ(stage.arm().pose().along_m, 0.0);
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

TEST(GelCamera, theArmMovesWhileItIsCommandedAndBrakesWhileItIsHeld) {
    auto link = std::make_shared<CarrierLink>();
    const auto made = makeGelCamera(dragged(0.0004), 1, nullptr, link);
    ASSERT_TRUE(made);
    core::GreyImage image;
    for (int i = 0; i < 5; ++i) {
        link->asked.post({.along_mPerS = 0.05});
        (void)(*made)->next(image, false);
    }
    const double moved_m = link->state.get().pose.along_m;
    EXPECT_GT(moved_m, 0.005);
    EXPECT_FALSE(link->state.get().held);
    link->asked.post({.along_mPerS = 0.05});
    (void)(*made)->next(image, true); // 5 m/s^2 brake 0.05 m/s in 10 ms
    EXPECT_TRUE(link->state.get().held);
    EXPECT_NEAR(link->state.get().pose.along_m, moved_m, 1e-12);
    (void)(*made)->next(image, false);
    EXPECT_NEAR(link->state.get().pose.along_m, moved_m, 1e-12) << "what was asked before moves nothing";
}

} // namespace teleta::simulation
