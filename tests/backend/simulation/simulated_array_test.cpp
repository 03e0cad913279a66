// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/simulation/array/simulated_array.h"
#include "tests/backend/simulation/array_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>

using namespace teleta;
using namespace teleta::simulation;
using namespace teleta::simulation::test;

namespace {

using Frame = std::vector<float>;

std::unique_ptr<SimulatedArray> make(const scene::Scene& scene, std::uint64_t seed = 1) {
    auto array = SimulatedArray::make(scene, seed);
    EXPECT_TRUE(array) << describe(array.error());
    return std::move(*array);
}

std::vector<Frame> frames(SimulatedArray& array, int count, bool motionHeld = false) {
    std::vector<Frame> result;
    for (int i = 0; i < count; ++i) {
        result.emplace_back(array.description().layout.taxels());
        array.next(result.back(), motionHeld);
    }
    return result;
}

/// Equal byte for byte, NaN included.
bool identical(const std::vector<Frame>& a, const std::vector<Frame>& b) {
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].size() != b[i].size() ||
            std::memcmp(a[i].data(), b[i].data(), a[i].size() * sizeof(float)) != 0)
            return false;
    return true;
}

scene::Scene shipped(const char* name) {
    const auto scene = scene::readScene(std::string(TELETA_SOURCE_DIR "/resources/scenes/") + name);
    EXPECT_TRUE(scene) << describe(scene.error());
    return *scene;
}

scene::Effect effect(decltype(scene::Effect::parameters) parameters) {
    return {.why = "test", .parameters = std::move(parameters)};
}

} // namespace

TEST(SimulatedArray, describesItselfAsSimulated) {
    const auto array = make(shipped("tactile-indenter.toml"));
    const core::SourceDescription description = array->description();
    EXPECT_EQ(description.name, "Ball and bar on a tactile array");
    EXPECT_EQ(description.layout, (core::ArrayLayout{6, 14, 0.0034}));
    EXPECT_EQ(description.unit, "N");
    EXPECT_EQ(description.nominalRate_Hz, 200.0);
    EXPECT_TRUE(description.simulated);
    EXPECT_FALSE(description.recorded);
}

TEST(SimulatedArray, makesTheSameBytesFromTheSameSceneAndSeed) {
    for (const char* name : {"tactile-indenter.toml", "tactile-two-contacts.toml", "tactile-mat.toml"}) {
        scene::Scene scene = shipped(name);
        scene.effects.push_back(effect(scene::DriftSpec{.sd_N = 0.05, .timeConstant_s = 60.0}));
        const auto first = make(scene, 5);
        const std::vector<Frame> expected = frames(*first, 300);
        EXPECT_TRUE(identical(frames(*make(scene, 5), 300), expected));
        EXPECT_FALSE(identical(frames(*make(scene, 6), 300), expected));
        first->restart();
        EXPECT_EQ(first->time_s(), 0.0);
        EXPECT_TRUE(identical(frames(*first, 300), expected));
    }
}

TEST(SimulatedArray, advancesByOnePeriodAFrame) {
    const auto array = make(emptyScene());
    EXPECT_EQ(array->time_s(), 0.0);
    frames(*array, 200);
    EXPECT_DOUBLE_EQ(array->time_s(), 1.0);
    frames(*array, 1);
    EXPECT_DOUBLE_EQ(array->time_s(), 1.005);
}

TEST(SimulatedArray, followsTheMotionAndKnowsTheTruth) {
    scene::Scene scene = emptyScene();
    scene.array().indenters = {
        {.name = "ball",
         .shape = scene::Sphere{0.008},
         .keyframes = {{0.0, 0.0, 0.0, -0.001, 0.0}, {1.0, 0.004, 0.001, 0.001, 0.0}}}};
    const auto array = make(scene);
    frames(*array, 1);
    EXPECT_EQ(array->truth().indenters[0].load.force_N, 0.0);
    const Frame last = frames(*array, 199).back();
    const ContactTruth& truth = array->truth();
    EXPECT_DOUBLE_EQ(truth.motionTime_s, 1.0);
    ASSERT_EQ(truth.indenters.size(), 1U);
    EXPECT_EQ(truth.indenters[0].name, "ball");
    EXPECT_DOUBLE_EQ(truth.indenters[0].pose.x_m, 0.004);
    EXPECT_DOUBLE_EQ(truth.indenters[0].pose.depth_m, 0.001);
    const double expected_N = 1200.0 / (0.0034 * 0.0034) * sphereVolume_m3(0.008, 0.001);
    EXPECT_NEAR(truth.indenters[0].load.force_N, expected_N, 0.01 * expected_N);
    EXPECT_NEAR(std::accumulate(last.begin(), last.end(), 0.0), truth.indenters[0].load.force_N, 1e-5);
    EXPECT_NEAR(*truth.indenters[0].load.copX_m, 0.004, 1e-5);
}

TEST(SimulatedArray, holdsTheMotionButNotTheSensorWhileStopIsEngaged) {
    scene::Scene scene = shipped("tactile-indenter.toml");
    const auto array = make(scene);
    frames(*array, 500);
    const double held_s = array->truth().motionTime_s;
    const Pose pose = array->truth().indenters[0].pose;
    const std::vector<Frame> held = frames(*array, 10, true);
    EXPECT_EQ(array->truth().motionTime_s, held_s);
    EXPECT_EQ(array->truth().indenters[0].pose.x_m, pose.x_m);
    EXPECT_DOUBLE_EQ(array->time_s(), 510 / 200.0);
    EXPECT_NE(held[8], held[9]) << "noise goes on";

    frames(*array, 1);
    EXPECT_DOUBLE_EQ(array->truth().motionTime_s, held_s + 1.0 / 200.0) << "it goes on where it was";

    scene.effects.clear();
    const auto silent = make(scene);
    frames(*silent, 500);
    const std::vector<Frame> still = frames(*silent, 2, true);
    EXPECT_EQ(still[0], still[1]);
}

TEST(SimulatedArray, readsNothingBelowTheFiringThreshold) {
    scene::Scene scene = pressedScene(scene::Sphere{0.012}, {0.001, 0.0005, 0.001, 0.0});
    const Frame all = frames(*make(scene), 1)[0];
    scene.array().sensor.firingThreshold_N = 0.2;
    const Frame fired = frames(*make(scene), 1)[0];
    int silent = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(fired[i], all[i] < 0.2F ? 0.0F : all[i]);
        silent += all[i] > 0.0F && fired[i] == 0.0F ? 1 : 0;
    }
    EXPECT_GT(silent, 0);
}

TEST(SimulatedArray, buildsOnlyTheEffectsThatTheSceneLists) {
    EXPECT_TRUE(make(emptyScene())->effectTimes().empty());
    scene::Scene scene = emptyScene();
    scene.effects = {effect(scene::NoiseSpec{0.01}), effect(scene::CrosstalkSpec{0.1})};
    const auto array = make(scene);
    frames(*array, 10);
    const std::vector<EffectTime> times = array->effectTimes();
    ASSERT_EQ(times.size(), 2U);
    EXPECT_EQ(times[0].name, "crosstalk");
    EXPECT_EQ(times[1].name, "noise");
    EXPECT_GT(times[1].time_s, 0.0);
}

TEST(SimulatedArray, givesEachEffectItsOwnRandomStream) {
    const scene::Effect noise = effect(scene::NoiseSpec{0.05});
    const scene::Effect drift = effect(scene::DriftSpec{0.1, 5.0});
    const scene::Effect dead = effect(scene::DeadTaxelsSpec{.taxels = {}, .count = 7, .reading_N = -5.0});
    const auto run = [](std::vector<scene::Effect> effects) {
        scene::Scene scene = emptyScene();
        scene.effects = std::move(effects);
        return frames(*make(scene), 50);
    };
    const std::vector<Frame> noiseOnly = run({noise});
    const std::vector<Frame> driftOnly = run({drift});
    const std::vector<Frame> deadOnly = run({dead});
    const std::vector<Frame> all = run({noise, drift, dead});
    EXPECT_TRUE(identical(all, run({dead, drift, noise}))) << "the order in the scene does not matter";
    for (std::size_t f = 0; f < all.size(); ++f) {
        for (std::size_t i = 0; i < all[f].size(); ++i) {
            if (deadOnly[f][i] == -5.0F)
                EXPECT_EQ(all[f][i], -5.0F);
            else
                EXPECT_NEAR(all[f][i], noiseOnly[f][i] + driftOnly[f][i], 1e-6);
        }
    }
}

TEST(SimulatedArray, conservesTheTotalForceThroughCrosstalk) {
    scene::Scene scene = pressedScene(scene::Cylinder{0.004, 0.02}, {0.01, 0.006, 0.0015, 0.3});
    scene.effects = {effect(scene::CrosstalkSpec{0.4})};
    const auto array = make(scene);
    const Frame frame = frames(*array, 1)[0];
    EXPECT_NEAR(std::accumulate(frame.begin(), frame.end(), 0.0), array->truth().indenters[0].load.force_N,
                1e-5);
}

TEST(SimulatedArray, refusesASceneThatIsNotValid) {
    scene::Scene scene = emptyScene();
    scene.array().sensor.layout.rows = 0;
    EXPECT_FALSE(SimulatedArray::make(scene, 1));
    EXPECT_FALSE(makeTactileArray(scene, 1));
    const auto generator = makeTactileArray(emptyScene(), 1);
    ASSERT_TRUE(generator);
    EXPECT_EQ((*generator)->description().nominalRate_Hz, 200.0);
}

// What a person sees in a loop: the ball presses, later only the bar does, and both are up at the seam.
TEST(ShippedScenes, pressWhatTheirDescriptionsSay) {
    const auto array = make(shipped("tactile-indenter.toml"));
    const auto forceAt = [&](double time_s, std::size_t indenter) {
        while (array->time_s() < time_s)
            frames(*array, 1);
        return array->truth().indenters[indenter].load.force_N;
    };
    EXPECT_GT(forceAt(4.4, 0), 5.0);
    EXPECT_EQ(forceAt(9.6, 0), 0.0);
    EXPECT_EQ(forceAt(9.7, 1), 0.0);
    EXPECT_GT(forceAt(14.0, 1), 5.0);
    EXPECT_EQ(forceAt(20.0, 1), 0.0);
    EXPECT_GT(forceAt(24.4, 0), 5.0);
}
