// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/simulated_tube.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::simulation {
namespace {

/// Small images: what is tested does not depend on their size.
scene::Scene smallScene(bool withNoise) {
    scene::Scene scene = test::cameraScene(withNoise);
    scene.camera().camera.width_px = 547;
    scene.camera().camera.height_px = 411;
    scene.camera().camera.focalLength_px = 196.0;
    return scene;
}

scene::Finger finger() {
    return {.name = "finger",
            .radius_m = 0.01,
            .keyframes = {{.time_s = 0.0, .angle_rad = 0.3, .z_m = 0.03, .depth_m = -0.001},
                          {.time_s = 0.2, .angle_rad = 0.3, .z_m = 0.03, .depth_m = 0.0015},
                          {.time_s = 0.4, .angle_rad = 0.5, .z_m = 0.035, .depth_m = 0.0015}}};
}

/// Centre of the dark pixels around a place.
Eigen::Vector2d darkCentre(const cv::Mat1b& image, const Eigen::Vector2d& around, int half) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0.0;
    for (int v = static_cast<int>(around.y()) - half; v <= static_cast<int>(around.y()) + half; ++v) {
        for (int u = static_cast<int>(around.x()) - half; u <= static_cast<int>(around.x()) + half; ++u) {
            const double dark = std::max(0.0, 125.0 - static_cast<double>(image(v, u)));
            sum += dark * Eigen::Vector2d(u, v);
            weight += dark;
        }
    }
    return sum / weight;
}

} // namespace

TEST(SimulatedTube, showsEachDotWhereTheCameraProjectsItToAtRestAndUnderAPress) {
    scene::Scene scene = test::cameraScene(false);
    scene.effects.resize(1); // the lens alone
    auto tube = SimulatedTube::make(scene, 1);
    ASSERT_TRUE(tube) << describe(tube.error());
    const double radius_m = scene.camera().skin.radius_m;
    const vision::CameraModel& camera = (*tube)->camera().camera();
    SkinDeformation deformation(radius_m, scene.camera().skin.reach_m);
    const std::vector<SkinPress> presses{{.centre = {0.4, 0.02},
                                          .ballRadius_m = 0.012,
                                          .depth_m = 0.001,
                                          .dragAround_m = 0.0003,
                                          .dragAlong_m = -0.0002}};
    deformation.set(presses);
    cv::Mat1b rest;
    cv::Mat1b pressed;
    (*tube)->untouched(rest);
    (*tube)->pressed(presses, pressed);
    int moved = 0;
    for (const PrintedDots::Dot& dot : (*tube)->renderer().dots().dots()) {
        if (dot.place.z_m > 0.03 || dot.place.z_m < 0.004)
            continue;
        const auto at = [&](double rho_m, const SkinPlace& place) {
            return *camera.project(
                {rho_m * std::cos(place.angle_rad), rho_m * std::sin(place.angle_rad), place.z_m});
        };
        const Eigen::Vector2d atRest_px = at(radius_m, dot.place);
        EXPECT_LT((darkCentre(rest, atRest_px, 14) - atRest_px).norm(), 0.5) << dot.place.z_m;
        // Where the skin is now: the inverse of atRest by fixed-point iteration.
        SkinPlace now = dot.place;
        for (int i = 0; i < 50; ++i) {
            const SkinPlace back = deformation.atRest(now.angle_rad, now.z_m);
            now = {now.angle_rad + dot.place.angle_rad - back.angle_rad, now.z_m + dot.place.z_m - back.z_m};
        }
        const double depth_m = deformation.depth_m(now.angle_rad, now.z_m);
        const Eigen::Vector2d now_px = at(radius_m - depth_m, now);
        moved += depth_m > 0.0003 ? 1 : 0;
        // The middle of a disc's image is not the image of its middle where the surface is bent.
        EXPECT_LT((darkCentre(pressed, now_px, 14) - now_px).norm(), 1.2) << dot.place.z_m;
    }
    EXPECT_GE(moved, 3);
}

TEST(SimulatedTube, givesTheSameFramesForTheSameSeedAndOthersForAnotherOne) {
    scene::Scene scene = smallScene(true);
    scene.camera().fingers.push_back(finger());
    auto one = SimulatedTube::make(scene, 5);
    auto same = SimulatedTube::make(scene, 5);
    auto other = SimulatedTube::make(scene, 6);
    ASSERT_TRUE(one && same && other);
    cv::Mat1b a, b, c;
    for (int i = 0; i < 12; ++i) {
        (*one)->next({}, a);
        (*same)->next({}, b);
        (*other)->next({}, c);
    }
    EXPECT_EQ(cv::countNonZero(a != b), 0);
    EXPECT_GT(cv::countNonZero(a != c), 0);
}

TEST(SimulatedTube, leavesTheStreamsOfOtherEffectsAloneWhenOneIsTakenAway) {
    scene::Scene scene = smallScene(true);
    auto all = SimulatedTube::make(scene, 5);
    std::erase_if(scene.effects,
                  [](const scene::Effect& effect) { return nameOf(effect) == "marker_print_error"; });
    auto fewer = SimulatedTube::make(scene, 5);
    ASSERT_TRUE(all && fewer);
    cv::Mat1b a, b;
    (*all)->untouched(a);
    (*fewer)->untouched(b);
    // The corner shows the housing: noise alone.
    const cv::Rect corner(0, 0, 40, 40);
    EXPECT_EQ(cv::countNonZero(a(corner) != b(corner)), 0);
    EXPECT_GT(cv::countNonZero(a != b), 0);
}

TEST(SimulatedTube, knowsTheFingerInTheTubesFrameWhenTheArmMoves) {
    scene::Scene scene = smallScene(false);
    scene.camera().fingers.push_back(finger());
    auto tube = SimulatedTube::make(scene, 1);
    ASSERT_TRUE(tube);
    cv::Mat1b frame;
    for (int i = 0; i < 16; ++i)
        (*tube)->next({.turn_radPerS = 0.2, .along_mPerS = 0.01}, frame);
    const FingerTruth& truth = (*tube)->truth().front();
    const TubePose& pose = (*tube)->arm().pose();
    EXPECT_GT(pose.turn_rad, 0.05);
    EXPECT_TRUE(truth.touches);
    EXPECT_NEAR(truth.press.centre.angle_rad, truth.inBase.angle_rad - pose.turn_rad, 1e-12);
    EXPECT_NEAR(truth.press.centre.z_m, truth.inBase.z_m - pose.along_m, 1e-12);
    EXPECT_NEAR(truth.press.depth_m, 0.0015, 1e-12);
}

TEST(SimulatedTube, movesTheFingerAwayFromTheSkinWhenTheArmDrawsBackFromIt) {
    scene::Scene scene = smallScene(false);
    scene.camera().fingers.push_back(finger());
    auto tube = SimulatedTube::make(scene, 1);
    ASSERT_TRUE(tube);
    cv::Mat1b frame;
    for (int i = 0; i < 8; ++i)
        (*tube)->next({}, frame);
    const double before_m = (*tube)->truth().front().press.depth_m;
    for (int i = 0; i < 4; ++i)
        (*tube)->next({.aside_mPerS = -0.05 * Eigen::Vector2d(std::cos(0.3), std::sin(0.3))}, frame);
    EXPECT_LT((*tube)->truth().front().press.depth_m, before_m - 0.002);
    EXPECT_FALSE((*tube)->truth().front().touches);
}

TEST(SimulatedTube, refusesALensThatFoldsAndOneOfNoNumbers) {
    scene::Scene scene = smallScene(false);
    scene.effects = {{"", scene::LensDistortionSpec{{-1e40, 0.0, 0.0, 0.0, 0.0, 0.0}, {}}}};
    ASSERT_TRUE(checkCameraScene(scene));
    const auto folded = SimulatedTube::make(scene, 1);
    ASSERT_FALSE(folded);
    EXPECT_NE(folded.error().message.find("folds"), std::string::npos) << folded.error().message;
    scene.effects = {{"", scene::LensDistortionSpec{{NAN, 0.0, 0.0, 0.0, 0.0, 0.0}, {}}}};
    EXPECT_FALSE(checkCameraScene(scene));
    EXPECT_FALSE(SimulatedTube::make(scene, 1));
}

} // namespace teleta::simulation
