// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/array/foundation_contact.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace teleta::simulation::test {

/// A 6 x 14 array without contact, threshold or effects; tests add what they are about.
inline scene::Scene emptyScene() {
    scene::Scene scene;
    scene.name = "test";
    scene.duration_s = 1.0;
    scene.rate_Hz = 200.0;
    scene.array().sensor = {
        .layout = {6, 14, 0.0034}, .stiffness_NPerM = 1200.0, .fullScale_N = 2.89, .firingThreshold_N = 0.0};
    return scene;
}

/// The same with a body that stays in one place.
inline scene::Scene pressedScene(const scene::IndenterShape& shape, const Pose& pose) {
    scene::Scene scene = emptyScene();
    scene.array().indenters.push_back(
        {.name = "body",
         .shape = shape,
         .keyframes = {{0.0, pose.x_m, pose.y_m, pose.depth_m, pose.angle_rad}}});
    return scene;
}

/// Loads of one body at one pose, and what the world knows of it.
struct Pressed {
    std::vector<double> load_N;
    IndenterLoad truth;

    [[nodiscard]] double total_N() const {
        double total_N = 0.0;
        for (const double load : load_N)
            total_N += load;
        return total_N;
    }
};

inline Pressed press(const core::ArrayLayout& layout, double stiffness_NPerM,
                     const scene::IndenterShape& shape, const Pose& pose) {
    Pressed result;
    result.load_N.resize(layout.taxels());
    RigidIndenter body(shape);
    body.moveTo(pose);
    FoundationContact(layout, stiffness_NPerM).press({&body, 1}, result.load_N, {&result.truth, 1});
    return result;
}

/// Volume of a ball below the surface: a cap, and upright walls from the equator on.
inline double sphereVolume_m3(double radius_m, double depth_m) {
    constexpr double kPi = std::numbers::pi;
    if (depth_m <= radius_m)
        return kPi * depth_m * depth_m * (radius_m - depth_m / 3.0);
    return kPi * radius_m * radius_m * (2.0 / 3.0 * radius_m + (depth_m - radius_m));
}

/// Area of a circular segment of height d, and upright walls from the equator on.
inline double segmentArea_m2(double radius_m, double depth_m) {
    if (depth_m <= radius_m)
        return radius_m * radius_m * std::acos((radius_m - depth_m) / radius_m) -
               (radius_m - depth_m) * std::sqrt(depth_m * (2.0 * radius_m - depth_m));
    return radius_m * (std::numbers::pi / 2.0 * radius_m + 2.0 * (depth_m - radius_m));
}

} // namespace teleta::simulation::test
