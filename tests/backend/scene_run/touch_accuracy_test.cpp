// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/scene_run.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <variant>

namespace teleta::scene_run {
namespace {

constexpr std::uint64_t kRuns = 40;

struct Object {
    const char* material;
    double stiffness_NPerM; ///< TeleTA, Table 2
    double tolerance;
};

constexpr std::array kObjects{Object{"sponge", 282.0, 0.05}, Object{"rubber_sponge", 1325.9, 0.05},
                              Object{"rubber", 7223.9, 0.05}, Object{"wood", 8562.9, 0.10}};

} // namespace

TEST(TouchAccuracy, touchesOfTheScenesFiveMaterialsAreWithinTheirTolerancesIn95PercentOfRuns) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/teleta-touch.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    std::array<int, kObjects.size()> within{};
    int boundedMetal = 0;
    for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
        RunOptions options;
        options.seed = seed;
        const auto summary = runScene(*scene, options);
        ASSERT_TRUE(summary) << describe(summary.error());
        const auto& estimated = summary->measures["estimated_stiffness_n_per_m"];
        const auto& material = summary->measures["material"];
        ASSERT_EQ(estimated.size(), kObjects.size() + 1) << "seed " << seed;
        for (std::size_t i = 0; i < kObjects.size(); ++i) {
            const bool right = estimated[i].is_number() &&
                               std::abs(estimated[i].get<double>() / kObjects[i].stiffness_NPerM - 1.0) <=
                                   kObjects[i].tolerance;
            within[i] += right ? 1 : 0;
        }
        // Rigid: no number, but at least stiffer than what counts as metal.
        const auto& metal = summary->events.back();
        if (estimated.back().is_null() && material.back() == "metal" &&
            metal["object_stiffness_lower_95"].get<double>() > 17234.0 &&
            metal["object_stiffness_upper_95"].is_null())
            ++boundedMetal;
    }
    const double least = 0.95 * static_cast<double>(kRuns);
    for (std::size_t i = 0; i < kObjects.size(); ++i) {
        std::cout << kObjects[i].material << ": " << within[i] << " of " << kRuns << " within "
                  << 100.0 * kObjects[i].tolerance << " %\n";
        EXPECT_GE(within[i], least) << kObjects[i].material;
    }
    std::cout << "metal: " << boundedMetal << " of " << kRuns << " only bounded\n";
    EXPECT_GE(boundedMetal, least);
}

// The arm takes up its speed just before the touch, so that part of the torque before it is the links'.
TEST(TouchAccuracy, theIntervalsOfSoftObjectsThatAreApproachedQuicklyHoldTheTruth) {
    auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/teleta-touch.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    auto& world = std::get<scene::ArmWorld>(scene->world);
    std::get<scene::TouchProgram>(world.program).approach_radPerS = 0.03;
    for (scene::ArmObject& object : world.objects)
        object.stiffness_NPerM = 200.0;
    for (scene::Effect& effect : scene->effects)
        if (auto* noise = std::get_if<scene::TorqueNoiseSpec>(&effect.parameters))
            noise->sd_Nm = 0.0001;
    constexpr std::uint64_t kQuickRuns = 6;
    double covered = 0.0;
    for (std::uint64_t seed = 1; seed <= kQuickRuns; ++seed) {
        RunOptions options;
        options.seed = seed;
        const auto summary = runScene(*scene, options);
        ASSERT_TRUE(summary) << describe(summary.error());
        covered += summary->measures["stiffness_covered"].get<double>() / kQuickRuns;
        EXPECT_LT(summary->measures["stiffness_error_mean"].get<double>(), 0.03) << "seed " << seed;
    }
    EXPECT_GE(covered, 0.9);
}

} // namespace teleta::scene_run
