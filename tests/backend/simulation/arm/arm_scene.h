// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene_reader.h"
#include "backend/simulation/arm/simulated_arm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace teleta::simulation::test {

/// The paper's k_ri.
inline constexpr double kLink_NPerM = 3468.6;

inline scene::Scene shippedArm(const std::string& name) {
    auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/" + name);
    EXPECT_TRUE(scene) << describe(scene.error());
    return scene ? std::move(*scene) : scene::Scene{};
}

/// An arm whose elbow touches one round post of radius 1 mm at 0.175 m, where the force passes through the
/// shoulder; no effects.
inline scene::Scene postScene(double stiffness_NPerM) {
    constexpr double kDistance_m = 0.175;
    constexpr double kRadius_m = 0.001;
    scene::Scene scene;
    scene.name = "post";
    scene.duration_s = 10.0;
    scene.rate_Hz = 1000.0;
    scene::ArmWorld world;
    const double upperArm_m = world.body.upperArmLength_m;
    const double elbow_rad = std::acos(-kDistance_m / upperArm_m);
    const double away_m = world.body.halfThickness_m + kRadius_m;
    world.body.start_rad = {1.5707963267948966, 0.0, 0.0, elbow_rad - 0.15};
    world.skin.centreSide_rad = 3.141592653589793;
    world.objects.push_back(
        {.name = "post",
         .outline = scene::RoundOutline{kRadius_m},
         .x_m = upperArm_m + kDistance_m * std::cos(elbow_rad) - away_m * std::sin(elbow_rad),
         .y_m = kDistance_m * std::sin(elbow_rad) + away_m * std::cos(elbow_rad),
         .stiffness_NPerM = stiffness_NPerM});
    scene.world = std::move(world);
    return scene;
}

inline std::unique_ptr<SimulatedArm> made(const scene::Scene& scene, std::uint64_t seed = 1) {
    auto arm = SimulatedArm::make(scene, seed);
    EXPECT_TRUE(arm) << describe(arm.error());
    return arm ? std::move(*arm) : nullptr;
}

} // namespace teleta::simulation::test
