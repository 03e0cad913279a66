// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/tube_camera.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace teleta;
using simulation::CarrierLink;
using simulation::TubeCameraSource;
using simulation::TubeVelocity;

namespace {

/// A small camera, so that frames are drawn quickly; one finger presses from the middle of the second on.
scene::Scene pressedScene() {
    scene::Scene scene = test::cameraScene(false);
    scene::CameraWorld& world = std::get<scene::CameraWorld>(scene.world);
    world.camera.width_px = 410;
    world.camera.height_px = 308;
    world.camera.focalLength_px = 147.0;
    scene::Finger finger;
    finger.name = "finger";
    finger.keyframes = {{0.0, 0.5, 0.03, -0.003}, {0.5, 0.5, 0.03, 0.002}, {1.0, 0.5, 0.03, 0.002}};
    world.fingers.push_back(finger);
    scene.duration_s = 1.0;
    return scene;
}

struct Camera {
    explicit Camera(const scene::Scene& scene)
        : source(std::move(*simulation::makeTubeCamera(scene, 1, link, control))) {}

    bool next(bool held = false) { return source.generator->next(image, held); }
    [[nodiscard]] simulation::CarrierState state() const { return link->state.get(); }

    std::shared_ptr<CarrierLink> link = std::make_shared<CarrierLink>();
    std::shared_ptr<core::SceneControl> control = std::make_shared<core::SceneControl>();
    TubeCameraSource source;
    core::GreyImage image;
};

bool same(const core::GreyImage& a, const core::GreyImage& b) {
    return a.width_px == b.width_px && a.height_px == b.height_px &&
           std::memcmp(a.pixels.get(), b.pixels.get(),
                       static_cast<std::size_t>(a.width_px) * static_cast<std::size_t>(a.height_px)) == 0;
}

} // namespace

TEST(TubeCamera, isHeldAndBegunAnewWhenSomebodyAsksForIt) {
    Camera camera(pressedScene());
    camera.next();
    const core::GreyImage reference = camera.image;
    for (int i = 0; i < 35; ++i)
        EXPECT_FALSE(camera.next());
    const core::GreyImage pressed = camera.image;
    EXPECT_FALSE(same(pressed, reference));
    camera.control->restart();
    EXPECT_FALSE(camera.next(true)) << "nothing begins under STOP";
    EXPECT_FALSE(camera.next());
    camera.control->setRunning(false);
    EXPECT_FALSE(camera.next());
    EXPECT_TRUE(camera.state().held);
    camera.control->restart();
    EXPECT_TRUE(camera.next());
    EXPECT_TRUE(same(camera.image, reference));
    EXPECT_EQ(camera.state().restarts, 1U);
}

TEST(TubeCamera, showsTheTubeUntouchedFirstAndThePressLater) {
    Camera camera(pressedScene());
    camera.next();
    const core::GreyImage reference = camera.image;
    EXPECT_EQ(reference.width_px, 410);
    EXPECT_EQ(reference.height_px, 308);
    camera.next();
    EXPECT_TRUE(same(camera.image, reference)) << "the finger is still away, and there is no noise";
    for (int i = 0; i < 30; ++i)
        camera.next();
    EXPECT_FALSE(same(camera.image, reference));
    EXPECT_TRUE(camera.source.generator->description().simulated);
}

TEST(TubeCamera, movesItsArmOnlyWhileItIsCommanded) {
    Camera camera(pressedScene());
    camera.next();
    camera.link->asked.post({.along_mPerS = 0.1});
    for (int i = 0; i < 4; ++i)
        camera.next();
    const double commanded_m = camera.state().pose.along_m;
    EXPECT_GT(commanded_m, 0.005);
    EXPECT_FALSE(camera.state().held);
    for (int i = 0; i < 20; ++i)
        camera.next();
    const double braked_m = camera.state().pose.along_m;
    EXPECT_TRUE(camera.state().held);
    // It brakes from 0.1 m/s with 5 m/s^2 within 1 mm, after at most one more frame under way.
    EXPECT_LT(braked_m, commanded_m + 0.1 / 40.0 + 0.0011);
    camera.next();
    EXPECT_EQ(camera.state().pose.along_m, braked_m);
}

TEST(TubeCamera, standsUnderStopAndForgetsWhatWasAskedMeanwhile) {
    Camera camera(pressedScene());
    camera.next();
    camera.link->asked.post({.turn_radPerS = 1.0});
    camera.next();
    for (int i = 0; i < 20; ++i) {
        camera.link->asked.post({.turn_radPerS = 1.0});
        camera.next(true);
    }
    const double stopped_rad = camera.state().pose.turn_rad;
    EXPECT_TRUE(camera.state().held);
    EXPECT_LT(stopped_rad, 0.06);
    camera.next();
    camera.next();
    EXPECT_EQ(camera.state().pose.turn_rad, stopped_rad);
    camera.link->asked.post({.turn_radPerS = 1.0});
    camera.next();
    EXPECT_GT(camera.state().pose.turn_rad, stopped_rad);
}

TEST(TubeCamera, beginsAnewAfterItsEndButNotUnderStop) {
    scene::Scene scene = pressedScene();
    scene.duration_s = 0.1;
    Camera camera(scene);
    camera.next();
    const core::GreyImage reference = camera.image;
    camera.link->asked.post({.along_mPerS = 0.1});
    int frames = 0;
    const int end = static_cast<int>((0.1 + simulation::kCarrierPause_s) * 40.0);
    for (; frames < end; ++frames)
        ASSERT_FALSE(camera.next()) << frames;
    for (int i = 0; i < 5; ++i)
        EXPECT_FALSE(camera.next(true));
    EXPECT_GT(camera.state().pose.along_m, 0.0);
    camera.link->asked.post({.along_mPerS = 0.1}); // to the arm of before
    EXPECT_TRUE(camera.next());
    EXPECT_EQ(camera.state().restarts, 1U);
    EXPECT_EQ(camera.state().pose.along_m, 0.0);
    EXPECT_TRUE(same(camera.image, reference)) << "the finger is away again";
    EXPECT_NEAR(camera.source.generator->time_s(), (end + 7) / 40.0, 1e-12) << "time goes on";
}

TEST(TubeCamera, refusesASceneThatIsNoCamerasOne) {
    const auto made = simulation::makeTubeCamera(scene::Scene{}, 1, std::make_shared<CarrierLink>());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().kind, core::ErrorKind::badInput);
}
