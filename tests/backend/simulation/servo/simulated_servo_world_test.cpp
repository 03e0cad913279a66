// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/simulation/servo/servo_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace teleta::simulation {
namespace {

scene::Scene straightBarScene() {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/servo-straight-bar.toml");
    EXPECT_TRUE(scene) << describe(scene.error());
    return scene ? *scene : scene::Scene();
}

std::unique_ptr<SimulatedServoWorld> worldOf(const scene::Scene& scene, std::uint64_t seed) {
    auto world = SimulatedServoWorld::make(scene, seed);
    EXPECT_TRUE(world) << describe(world.error());
    return std::move(*world);
}

/// Moves the reference towards the object for a while; all frames one after another.
std::vector<float> framesOf(SimulatedServoWorld& world, double duration_s, double speed_mPerS) {
    std::vector<float> frames;
    std::vector<float> frame(world.layout().taxels());
    Eigen::Isometry3d reference = world.arm().X_Base_Sensor();
    while (world.time_s() < duration_s) {
        reference.translation() += speed_mPerS / world.rate_Hz() * reference.linear().col(2);
        world.setReference(reference);
        world.next();
        if (world.frame(frame))
            frames.insert(frames.end(), frame.begin(), frame.end());
    }
    return frames;
}

} // namespace

TEST(Schedule, spreadsARateEvenlyOverFasterCycles) {
    for (const double rate_Hz : {1000.0, 200.0, 140.0, 100.0, 7.0}) {
        const Schedule schedule(rate_Hz, 1000.0);
        int events = 0;
        std::uint64_t last = 0;
        for (std::uint64_t cycle = 1; cycle <= 10000; ++cycle) {
            if (!schedule.isDue(cycle))
                continue;
            ++events;
            EXPECT_LE(static_cast<double>(cycle - last), std::ceil(1000.0 / rate_Hz) + 1.0);
            last = cycle;
        }
        EXPECT_EQ(events, std::lround(10.0 * rate_Hz)) << rate_Hz;
    }
    const Schedule faster(5000.0, 1000.0);
    EXPECT_TRUE(faster.isDue(1) && faster.isDue(2));
}

TEST(SimulatedServoWorld, readsTheArrayAtItsOwnRate) {
    const auto world = worldOf(straightBarScene(), 1);
    std::vector<float> frame(world->layout().taxels());
    int frames = 0;
    for (int i = 0; i < 1000; ++i) {
        world->next();
        frames += world->frame(frame) ? 1 : 0;
    }
    EXPECT_EQ(frames, 200);
}

TEST(SimulatedServoWorld, givesTheSameFramesForTheSameSeedAndOthersForAnother) {
    const scene::Scene scene = straightBarScene();
    const auto one = worldOf(scene, 3);
    const auto two = worldOf(scene, 3);
    const auto other = worldOf(scene, 4);
    const std::vector<float> frames = framesOf(*one, 1.6, 0.01);
    EXPECT_EQ(frames, framesOf(*two, 1.6, 0.01));
    EXPECT_NE(frames, framesOf(*other, 1.6, 0.01));
    one->restart();
    EXPECT_EQ(frames, framesOf(*one, 1.6, 0.01));
}

TEST(SimulatedServoWorld, anEffectLeavesTheObjectsPlaceAndOtherStreamsAlone) {
    scene::Scene scene = straightBarScene();
    const auto before = worldOf(scene, 5);
    scene.effects.push_back({"test", scene::QuantizationSpec{.step_N = 1e-9}});
    const auto after = worldOf(scene, 5);
    EXPECT_TRUE(before->arm().object().X_Base_Object.isApprox(after->arm().object().X_Base_Object, 0.0));
    const std::vector<float> plain = framesOf(*before, 1.2, 0.01);
    const std::vector<float> stepped = framesOf(*after, 1.2, 0.01);
    ASSERT_EQ(plain.size(), stepped.size());
    for (std::size_t i = 0; i < plain.size(); ++i)
        ASSERT_NEAR(plain[i], stepped[i], 1e-6); // a float's rounding
}

TEST(SimulatedServoWorld, theTrueForceIsWhatTheArrayAndItsHousingCarry) {
    scene::Scene scene = straightBarScene();
    scene.effects.push_back({"test", scene::HousingRimSpec{}});
    const auto world = worldOf(scene, 6);
    (void)framesOf(*world, 2.5, 0.01);
    const ServoFrameTruth& truth = world->frameTruth();
    ASSERT_TRUE(world->truth().touching);
    EXPECT_GT(truth.loads.rim_N, 0.0);
    std::vector<float> frame(world->layout().taxels());
    while (!world->frame(frame))
        world->next();
    EXPECT_NEAR(world->truth().force_N, world->frameTruth().loads.force_N + world->frameTruth().loads.rim_N,
                1e-9);
    ASSERT_EQ(world->effectTimes().size(), scene.effects.size());
}

TEST(SimulatedServoWorld, refusesAnotherScene) {
    EXPECT_FALSE(SimulatedServoWorld::make(scene::Scene(), 1));
}

} // namespace teleta::simulation
