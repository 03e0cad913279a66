// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/shared_keys.h"

#include <string>
#include <variant>
#include <vector>

namespace teleta::scene {

/// The tactile array of a scene: a plane of taxels, each a spring normal to the surface.
struct ArraySensor {
    core::ArrayLayout layout;
    double stiffness_NPerM = 1200.0; ///< of one taxel
    double fullScale_N = 2.89;       ///< load at which a taxel saturates, when the scene lists that effect
    double firingThreshold_N = 0.0;  ///< a taxel whose load is below this reads 0
    void describeKeys(Keys& keys);
};

/// A rigid ball.
struct Sphere {
    double radius_m = 0.0;
    void describeKeys(Keys& keys) { keys.number("radius_m", radius_m, kPositive, "Radius"); }
};

/// A rigid round bar that lies on the surface; its axis is along x at angle 0.
struct Cylinder {
    double radius_m = 0.0;
    double length_m = 0.0;
    void describeKeys(Keys& keys);
};

/// The sharp edge of a rigid box, its two faces at 45 degrees to the surface; the edge is along x at angle 0.
struct BoxEdge {
    double length_m = 0.0;
    void describeKeys(Keys& keys);
};

/// A rigid rectangular face that is parallel to the surface; its length is along x at angle 0.
struct FlatPunch {
    double length_m = 0.0;
    double width_m = 0.0;
    void describeKeys(Keys& keys);
};

using IndenterShape = std::variant<Sphere, Cylinder, BoxEdge, FlatPunch>;

/// Where an indenter is at a time. Frame {s} of the array.
struct Keyframe {
    double time_s = 0.0;
    double x_m = 0.0;
    double y_m = 0.0;
    double depth_m = 0.0;   ///< of the lowest point under the free surface; negative: above it
    double angle_rad = 0.0; ///< about z
};

/// A rigid body and its motion. Between keyframes it moves along monotone cubics: through every keyframe, at
/// rest where the motion turns back, never beyond the two keyframes on either side. It rests before the first
/// keyframe and after the last one, or goes on with the first one when the motion is a loop.
struct Indenter {
    std::string name;
    IndenterShape shape;
    std::vector<Keyframe> keyframes; ///< at least one, times strictly increasing
    bool loop = false;
    void describeKeys(Keys& keys);
};

/// A tactile array that lies still while bodies press on it.
struct ArrayWorld {
    ArraySensor sensor;
    std::vector<Indenter> indenters;
    void describeKeys(Keys& keys);
};

} // namespace teleta::scene
