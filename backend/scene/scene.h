// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/arm_world.h"
#include "backend/scene/array_world.h"
#include "backend/scene/camera_world.h"
#include "backend/scene/servo_world.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace teleta::scene {

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

/// Readings come late, as over a bus or through a filter: so many whole frames as are nearest to the delay.
struct LatencySpec {
    double delay_s = 0.0; ///< 0 .. 1
};

/// The reading is a parabola of the load, exact at 0 and at full scale, and most wrong half way between:
/// there it reads bow of the full scale too much. Piezoresistive cells read too much.
struct NonlinearResponseSpec {
    double bow = 0.0; ///< -0.25 .. 0.25, so that the reading rises with the load
};

/// No two taxels are made alike: each reads its load times a factor of its own, whose logarithm is normal.
struct GainSpreadSpec {
    double sd = 0.0; ///< of the logarithm; 0 .. 1
};

/// Gaussian noise of each joint torque, independent from sample to sample.
struct TorqueNoiseSpec {
    double sd_Nm = 0.0;
};

/// Joint angles are multiples of a step.
struct EncoderQuantizationSpec {
    double step_rad = 0.0;
};

/// The weight that is taken off the torques is wrong by this share of the links' true weight.
struct GravityErrorSpec {
    double share = 0.0;
};

/// The torque sensors sit at harmonic drives: their reading waves with the angle of the joint.
struct GearRippleSpec {
    double amplitude_Nm = 0.0;
    double wavesPerTurn = 0.0;
};

/// Objects that grow stiffer while they are pressed, as foams do.
///   F = k d (1 + d / doublingDepth_m)
struct NonlinearObjectSpec {
    double doublingDepth_m = 0.0; ///< depth at which the secant stiffness is twice k; > 0
};

/// The link between the operator and the arm. A message takes
///   delay_s + E,  E exponential with mean jitter_s
/// or is lost. Commands: the newest that has arrived counts. What the arm tells comes in order: a message
/// that was overtaken holds up those behind it.
struct LinkDelaySpec {
    double delay_s = 0.0;   ///< shortest time on the way, each way; 0 .. 10
    double jitter_s = 0.0;  ///< 0 .. 10
    double lossShare = 0.0; ///< of the messages, independent of each other; 0 .. 1
    double outageAt_s = 0.0;
    double outage_s = 0.0; ///< everything sent from outageAt_s on is lost for so long; 0: never
};

/// The cover is held from the sides: taxels along the border are stiffer by this share, corners by twice
/// that.
struct BorderStiffeningSpec {
    double share = 0.0; ///< >= 0
};

/// The housing around the sensitive area, lower by recess_m, carries what presses on it and senses nothing.
struct HousingRimSpec {
    double stiffness_NPerM = 2e5; ///< of a piece as long as a pitch; > 0
    double recess_m = 0.0005;     ///< >= 0
    double length_m = 0.050;      ///< along x, > the array's
    double width_m = 0.025;       ///< along y, > the array's
};

/// The cover gives back less than it takes: beside each pressed spring k acts a damper k time_s.
struct ContactDampingSpec {
    double time_s = 0.0; ///< >= 0
};

/// Dry friction of the object on the array's cover.
struct FrictionSpec {
    double coefficient = 0.0; ///< >= 0
};

/// One imperfection that the scene calls for. What is not listed is not simulated. The first ten are of
/// taxels, the next six of an arm, the next four of an array that an arm carries, the last six of a camera.
struct Effect {
    std::string why; ///< what the scene would lose without it
    std::variant<NoiseSpec, QuantizationSpec, SaturationSpec, DeadTaxelsSpec, CrosstalkSpec, HysteresisSpec,
                 DriftSpec, LatencySpec, NonlinearResponseSpec, GainSpreadSpec, TorqueNoiseSpec,
                 EncoderQuantizationSpec, GravityErrorSpec, GearRippleSpec, NonlinearObjectSpec,
                 LinkDelaySpec, BorderStiffeningSpec, HousingRimSpec, ContactDampingSpec, FrictionSpec,
                 LensDistortionSpec, UnevenLightSpec, SensorNoiseSpec, MotionBlurSpec, MarkerPrintErrorSpec,
                 VignettingSpec>
        parameters;
};

/// Kinds of effects that every tactile array can have; those after them need the world that they are of.
inline constexpr std::size_t kTaxelEffectKinds = 10;
inline constexpr std::size_t kArmEffectKinds = 6;
/// Kinds that a camera can have, the last ones.
inline constexpr std::size_t kCameraEffectKinds = 6;
inline constexpr std::size_t kFirstCameraEffect =
    std::variant_size_v<decltype(Effect::parameters)> - kCameraEffectKinds;

/// Name of an effect in files, in summaries and of its random stream: "noise", "dead_taxels".
[[nodiscard]] std::string_view nameOf(const Effect& effect);

/// A simulated world as its file describes it. SI units.
struct Scene {
    std::string name;
    std::string description;
    double duration_s = 0.0;
    double rate_Hz =
        0.0; ///< frames of an array or a camera, samples of an arm, control cycles of a servo a second
    std::variant<ArrayWorld, ArmWorld, CameraWorld, ServoWorld> world;
    std::vector<Effect> effects; ///< each kind at most once

    [[nodiscard]] bool isArm() const { return std::holds_alternative<ArmWorld>(world); }
    /// An operator at another place drives the arm.
    [[nodiscard]] bool isTeleoperated() const {
        return isArm() && std::holds_alternative<OperatorProgram>(arm().program);
    }
    [[nodiscard]] bool isServo() const { return std::holds_alternative<ServoWorld>(world); }
    [[nodiscard]] bool isCamera() const { return std::holds_alternative<CameraWorld>(world); }
    /// The world of a scene of that kind; throws std::bad_variant_access with the other.
    [[nodiscard]] const ArrayWorld& array() const { return std::get<ArrayWorld>(world); }
    [[nodiscard]] ArrayWorld& array() { return std::get<ArrayWorld>(world); }
    [[nodiscard]] const ArmWorld& arm() const { return std::get<ArmWorld>(world); }
    [[nodiscard]] ArmWorld& arm() { return std::get<ArmWorld>(world); }
    [[nodiscard]] const CameraWorld& camera() const { return std::get<CameraWorld>(world); }
    [[nodiscard]] CameraWorld& camera() { return std::get<CameraWorld>(world); }
    [[nodiscard]] const ServoWorld& servo() const { return std::get<ServoWorld>(world); }
    [[nodiscard]] ServoWorld& servo() { return std::get<ServoWorld>(world); }
    /// The parameters of an effect; null when the scene does not list it.
    template <typename Spec>
    [[nodiscard]] const Spec* listed() const {
        for (const Effect& effect : effects) {
            if (const auto* spec = std::get_if<Spec>(&effect.parameters))
                return spec;
        }
        return nullptr;
    }
    /// Taxels of the array, or of the arm's skin; a camera has none.
    [[nodiscard]] core::ArrayLayout taxels() const {
        if (isCamera())
            return {.rows = 0, .columns = 0};
        return isArm() ? arm().skin.layout : sensor().layout;
    }
    /// Load at which one of them saturates. Not of a camera.
    [[nodiscard]] double fullScale_N() const {
        return isArm() ? arm().skin.fullScale_N : sensor().fullScale_N;
    }

private:
    [[nodiscard]] const ArraySensor& sensor() const {
        return isServo() ? servo().sensor.array : array().sensor;
    }
};

/// Checks a scene that was made by a program rather than read from a file: sizes, signs, keyframes, dead
/// taxels, the arm, its objects and its program, effects that the world cannot have.
/// Error: badInput, without a place.
[[nodiscard]] core::Expected<void> checkScene(const Scene& scene);

/// The same, and that the scene is of this kind.
[[nodiscard]] core::Expected<void> checkArrayScene(const Scene& scene);
[[nodiscard]] core::Expected<void> checkArmScene(const Scene& scene);
/// An arm with an operator.
[[nodiscard]] core::Expected<void> checkTeleoperatedScene(const Scene& scene);
[[nodiscard]] core::Expected<void> checkCameraScene(const Scene& scene);
[[nodiscard]] core::Expected<void> checkServoScene(const Scene& scene);

} // namespace teleta::scene
