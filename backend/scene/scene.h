// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/array_layout.h"
#include "backend/core/error.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace teleta::scene {

/// The tactile array of a scene: a plane of taxels, each a spring normal to the surface.
struct ArraySensor {
    core::ArrayLayout layout;
    double stiffness_NPerM = 1200.0; ///< of one taxel; > 0
    double fullScale_N = 2.89; ///< load at which a taxel saturates, when the scene lists that effect; > 0
    double firingThreshold_N = 0.0; ///< a taxel whose load is below this reads 0; >= 0
};

/// A rigid ball.
struct Sphere {
    double radius_m = 0.0; ///< > 0
};

/// A rigid round bar that lies on the surface; its axis is along x at angle 0.
struct Cylinder {
    double radius_m = 0.0; ///< > 0
    double length_m = 0.0; ///< > 0
};

/// The sharp edge of a rigid box, its two faces at 45 degrees to the surface; the edge is along x at angle 0.
struct BoxEdge {
    double length_m = 0.0; ///< > 0
};

/// A rigid rectangular face that is parallel to the surface; its length is along x at angle 0.
struct FlatPunch {
    double length_m = 0.0; ///< > 0
    double width_m = 0.0;  ///< > 0
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
};

/// Gaussian noise on each taxel, independent from frame to frame.
struct NoiseSpec {
    double sd_N = 0.0;
};

/// Readings are multiples of a step.
struct QuantizationSpec {
    double step_N = 0.0;
};

/// Readings are limited to 0 .. ArraySensor::fullScale_N.
struct SaturationSpec {};

struct TaxelIndex {
    int row = 0;
    int column = 0;
};

/// Taxels that read one value whatever their load.
struct DeadTaxelsSpec {
    std::vector<TaxelIndex> taxels; ///< which ones; empty: count of them, drawn at random
    std::size_t count = 0;
    double reading_N = 0.0; ///< may be NaN
};

/// Each taxel hands this share of its load to its four neighbours in equal parts.
struct CrosstalkSpec {
    double share = 0.0; ///< 0 .. 1
};

/// While the load falls, the reading stays behind by up to this share of the load.
struct HysteresisSpec {
    double share = 0.0; ///< >= 0
};

/// Rest value of each taxel that wanders from 0 (the array is tared at the start) as an Ornstein-Uhlenbeck
/// process.
struct DriftSpec {
    double sd_N = 0.0; ///< after a time much longer than timeConstant_s
    double timeConstant_s = 0.0;
};

/// One imperfection that the scene calls for. What is not listed is not simulated.
struct Effect {
    std::string why; ///< what the scene would lose without it
    std::variant<NoiseSpec, QuantizationSpec, SaturationSpec, DeadTaxelsSpec, CrosstalkSpec, HysteresisSpec,
                 DriftSpec>
        parameters;
};

/// Name of an effect in files, in summaries and of its random stream: "noise", "dead_taxels".
[[nodiscard]] std::string_view nameOf(const Effect& effect);

/// A simulated world as its file describes it. SI units.
struct Scene {
    std::string name;
    std::string description;
    double duration_s = 0.0;
    double rate_Hz = 0.0; ///< frames a second
    ArraySensor sensor;
    std::vector<Indenter> indenters;
    std::vector<Effect> effects; ///< each kind at most once
};

/// Checks a scene that was made by a program rather than read from a file: sizes, signs, keyframes, dead
/// taxels.
/// Error: badInput, without a place.
[[nodiscard]] core::Expected<void> checkScene(const Scene& scene);

} // namespace teleta::scene
