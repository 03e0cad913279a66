// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/simulation/camera/skin_renderer.h"
#include "tests/backend/simulation/camera/camera_scene.h"
#include "tests/backend/simulation/camera/plain_skin_renderer.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <iostream>
#include <vector>

namespace teleta::simulation {
namespace {

constexpr int kFineSteps = 512; ///< of the plain renderer: at least 16 for one of the other

struct Case {
    const char* name;
    double lensAside_m;
    std::vector<SkinPress> presses;
};

std::vector<Case> cases() {
    const SkinPress near{
        .centre = {0.3, 0.02}, .depth_m = 0.0014, .dragAround_m = 0.0002, .dragAlong_m = -0.0001};
    const SkinPress middle{.centre = {2.6, 0.05}, .ballRadius_m = 0.012, .depth_m = 0.0013};
    const SkinPress far{.centre = {4.4, 0.082}, .ballRadius_m = 0.012, .depth_m = 0.0012};
    const SkinPress beside{.centre = {0.55, 0.03}, .ballRadius_m = 0.008, .depth_m = 0.001};
    const SkinPress acrossTheSeam{.centre = {3.14, 0.04}, .depth_m = 0.0015};
    const SkinPress atTheRim{.centre = {1.0, 0.001}, .depth_m = 0.0015};
    const SkinPress light{.centre = {5.5, 0.06}, .depth_m = 0.00005};
    const SkinPress deep{.centre = {-1.0, 0.06}, .ballRadius_m = 0.006, .depth_m = 0.003};
    return {{"fingers far from one another", 0.0, {near, middle, far}},
            {"fingers that touch each other's imprint", 0.0, {near, beside}},
            {"a finger at the angle where the turn begins anew", 0.0, {acrossTheSeam}},
            {"a finger at the rim", 0.0, {atTheRim}},
            {"a light one and one that hides much", 0.0, {light, deep}},
            {"a lens beside the axis", 0.0007, {near, middle, far, deep}}};
}

std::unique_ptr<SimulatedTube> tubeOf(double lensAside_m) {
    scene::Scene scene = test::cameraScene(false);
    scene.effects.resize(2); // lens and print: no light
    scene.camera().camera.width_px = 410;
    scene.camera().camera.height_px = 308;
    scene.camera().camera.focalLength_px = 146.75;
    scene.camera().camera.offsetX_m = 0.8 * lensAside_m;
    scene.camera().camera.offsetY_m = -0.6 * lensAside_m;
    return std::move(*SimulatedTube::make(scene, 1));
}

} // namespace

TEST(SkinRenderer, showsUnderPressesWhatAPlainFinerSearchShows) {
    for (const Case& one : cases()) {
        const auto tube = tubeOf(one.lensAside_m);
        const scene::CameraSkin skin;
        SkinDeformation deformation(skin.radius_m, skin.reach_m);
        deformation.set(one.presses);
        SkinRenderer renderer(tube->camera(), skin, tube->renderer().dots());
        const cv::Rect whole({0, 0}, renderer.atRest().size());
        cv::Mat1f image = renderer.atRest().clone();
        for (const cv::Rect& part : renderer.reach(deformation))
            renderer.draw(deformation, part, image);
        cv::Mat1f plain(whole.size());
        test::PlainSkinRenderer(renderer, skin, kFineSteps).draw(deformation, whole, plain);
        cv::Mat1f difference;
        cv::absdiff(image, plain, difference);
        const int moved = cv::countNonZero(plain != renderer.atRest());
        ASSERT_GT(moved, 100) << one.name;
        double most = 0.0;
        cv::minMaxLoc(difference, nullptr, &most);
        std::cout << one.name << ": " << moved << " pixels moved, mean difference "
                  << cv::sum(difference)[0] / moved << ", most " << most << " grey levels\n";
        // A ray that touches a press between two steps may meet it in one search alone.
        EXPECT_LT(cv::sum(difference)[0] / moved, 1e-3) << one.name;
        EXPECT_LE(cv::countNonZero(difference > 0.1F), moved / 1000) << one.name;
    }
}

TEST(SkinRenderer, drawsTheImageAtRestLikeThePlainOne) {
    const auto tube = tubeOf(0.0007);
    const scene::CameraSkin skin;
    const SkinRenderer renderer(tube->camera(), skin, tube->renderer().dots());
    const cv::Rect whole({0, 0}, renderer.atRest().size());
    cv::Mat1f plain(whole.size());
    test::PlainSkinRenderer(renderer, skin, kFineSteps)
        .draw(SkinDeformation(skin.radius_m, skin.reach_m), whole, plain);
    EXPECT_LT(cv::norm(renderer.atRest(), plain, cv::NORM_INF), 1e-3);
}

TEST(SkinRenderer, leavesWhatNoPressReachesAsItWas) {
    const auto tube = tubeOf(0.0);
    const scene::CameraSkin skin;
    SkinDeformation deformation(skin.radius_m, skin.reach_m);
    SkinRenderer renderer(tube->camera(), skin, tube->renderer().dots());
    EXPECT_TRUE(renderer.reach(deformation).empty());
    deformation.set({{.centre = {0.3, 0.02}, .depth_m = 0.0014}});
    const std::vector<cv::Rect> parts = renderer.reach(deformation);
    ASSERT_EQ(parts.size(), 1U);
    cv::Mat1f image(renderer.atRest().size(), -1.0F);
    renderer.draw(deformation, parts.front(), image);
    EXPECT_EQ(cv::countNonZero(image != -1.0F), parts.front().area());
    EXPECT_LT(parts.front().area(), image.rows * image.cols / 4);
}

} // namespace teleta::simulation
