// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/shared_keys.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace teleta::scene {

/// What an effect acts on, and thereby which scenes can list it.
enum class ActsOn {
    taxels,       ///< of any tactile array: a scene's own, an arm's skin, the one a servoing arm carries
    joints,       ///< the joint sensors of an arm
    armObjects,   ///< what an arm touches
    link,         ///< between an arm and its operator
    carriedArray, ///< the contact of the array that a servoing arm carries
    camera,       ///< the camera inside a soft tube
};

/// A row of the table of effects. Each type below is one; its describeKeys() says what its values mean. Its
/// maker, where one is needed, is
///   makeEffect(const simulation::Listed<Spec>&)
/// in backend/simulation.
struct EffectRow {
    std::string_view name; ///< in files and summaries, and of its random stream
    ActsOn actsOn;
    std::string_view why; ///< what it stands for in the real world
};

struct CrosstalkSpec {
    static constexpr EffectRow kRow{"crosstalk", ActsOn::taxels,
                                    "The elastic cover spreads a load to the neighbouring taxels"};
    double share = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("share", share, kShare,
                    "Share of its load that a taxel hands to its four neighbours in equal parts");
    }
};

struct HysteresisSpec {
    static constexpr EffectRow kRow{"hysteresis", ActsOn::taxels,
                                    "The reading lags behind while the load falls"};
    double share = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("share", share, NumberRange::between(0.0, 10.0),
                    "How far the reading lags behind, as a share of the load");
    }
};

/// The reading is a parabola of the load, exact at 0 and at full scale, and most wrong half way between:
/// there it reads bow of the full scale too much. Piezoresistive cells read too much.
struct NonlinearResponseSpec {
    static constexpr EffectRow kRow{
        "nonlinear_response", ActsOn::taxels,
        "The reading is not proportional to the load, as with piezoresistive cells"};
    double bow = 0.0; ///< within these limits the reading rises with the load
    void describeKeys(Keys& keys) {
        keys.number("bow", bow, NumberRange::between(-0.25, 0.25),
                    "Error half way to full scale, as a share of full scale");
    }
};

struct GainSpreadSpec {
    static constexpr EffectRow kRow{"gain_spread", ActsOn::taxels, "No two taxels are made alike"};
    double sd = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("sd", sd, NumberRange::between(0.0, 1.0),
                    "Standard deviation of the logarithm of the taxels' gains");
    }
};

/// Ornstein-Uhlenbeck processes that begin at 0, since the array is tared at the start.
struct DriftSpec {
    static constexpr EffectRow kRow{"drift", ActsOn::taxels, "The rest values of the taxels wander"};
    double sd_N = 0.0; ///< after a time much longer than timeConstant_s
    double timeConstant_s = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("sd_N", sd_N, kNotNegative,
                    "Standard deviation after a time much longer than the time constant");
        keys.number("time_constant_s", timeConstant_s, kPositive,
                    "Time after which a rest value has mostly forgotten where it was");
    }
};

struct NoiseSpec {
    static constexpr EffectRow kRow{"noise", ActsOn::taxels,
                                    "Gaussian noise on each taxel, independent from frame to frame"};
    double sd_N = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("sd_N", sd_N, kNotNegative, "Standard deviation of the noise");
    }
};

struct SaturationSpec {
    static constexpr EffectRow kRow{"saturation", ActsOn::taxels,
                                    "Readings are limited to the range from 0 to full scale"};
    void describeKeys(Keys&) {}
};

struct QuantizationSpec {
    static constexpr EffectRow kRow{"quantization", ActsOn::taxels, "Readings are multiples of a step"};
    double step_N = 0.0;
    void describeKeys(Keys& keys) { keys.number("step_N", step_N, kPositive, "The step"); }
};

struct TaxelIndex {
    int row = 0;
    int column = 0;
};

struct DeadTaxelsSpec {
    static constexpr EffectRow kRow{"dead_taxels", ActsOn::taxels,
                                    "Some taxels read one value, whatever their load"};
    std::vector<TaxelIndex> taxels; ///< which ones; empty: count of them, drawn at random
    std::size_t count = 0;
    double reading_N = 0.0; ///< may be NaN
    void describeKeys(Keys& keys, const core::ArrayLayout& layout);
};

struct LatencySpec {
    static constexpr EffectRow kRow{"latency", ActsOn::taxels,
                                    "Readings come late, as over a bus or through a filter"};
    double delay_s = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("delay_s", delay_s, NumberRange::between(0.0, 1.0), "The delay, rounded to whole frames");
    }
};

struct GravityErrorSpec {
    static constexpr EffectRow kRow{"gravity_error", ActsOn::joints,
                                    "The model of the arm's weight is a little wrong"};
    double share = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("share", share, NumberRange::between(-1.0, 1.0),
                    "Error of the weight compensation, as a share of the links' weight");
    }
};

struct GearRippleSpec {
    static constexpr EffectRow kRow{"gear_ripple", ActsOn::joints,
                                    "The torque sensors sit at harmonic drives, whose ripple they feel"};
    double amplitude_Nm = 0.0;
    double wavesPerTurn = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("amplitude_Nm", amplitude_Nm, kNotNegative, "Amplitude of the ripple");
        keys.number("waves_per_turn", wavesPerTurn, kPositive, "Ripples in a turn of the motor");
    }
};

struct TorqueNoiseSpec {
    static constexpr EffectRow kRow{"torque_noise", ActsOn::joints,
                                    "Gaussian noise on each joint torque, independent from sample to sample"};
    double sd_Nm = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("sd_Nm", sd_Nm, kNotNegative, "Standard deviation of the noise");
    }
};

struct EncoderQuantizationSpec {
    static constexpr EffectRow kRow{"encoder_quantization", ActsOn::joints,
                                    "Joint angles are multiples of a step"};
    double step_rad = 0.0;
    void describeKeys(Keys& keys) { keys.number("step_rad", step_rad, kPositive, "The step"); }
};

///   F = k d (1 + d / doublingDepth_m)
struct NonlinearObjectSpec {
    static constexpr EffectRow kRow{"nonlinear_object", ActsOn::armObjects,
                                    "Objects grow stiffer while they are pressed, as foams do"};
    double doublingDepth_m = 0.0; ///< depth at which the secant stiffness is twice k
    void describeKeys(Keys& keys) {
        keys.number("doubling_depth_m", doublingDepth_m, kPositive,
                    "Depth at which the force is twice that of a linear object");
    }
};

/// The link between the operator and the arm. A message takes
///   delay_s + E,  E exponential with mean jitter_s
/// or is lost. Commands: the newest that has arrived counts. What the arm tells comes in order: a message
/// that was overtaken holds up those behind it.
struct LinkDelaySpec {
    static constexpr EffectRow kRow{"link_delay", ActsOn::link,
                                    "Messages between operator and arm take time and get lost"};
    double delay_s = 0.0; ///< shortest time on the way, each way
    double jitter_s = 0.0;
    double lossShare = 0.0; ///< of the messages, independent of each other
    double outageAt_s = 0.0;
    double outage_s = 0.0; ///< everything sent from outageAt_s on is lost for so long; 0: never
    void describeKeys(Keys& keys) {
        const NumberRange time = NumberRange::between(0.0, 10.0);
        keys.number("delay_s", delay_s, time, "Shortest time that a message takes, each way");
        keys.number("jitter_s", jitter_s, time, "Mean of the random time that is added to it",
                    Need::optional);
        keys.number("loss_share", lossShare, kShare, "Share of the messages that are lost", Need::optional);
        keys.number("outage_at_s", outageAt_s, kNotNegative, "When the link breaks down", Need::optional);
        keys.number("outage_s", outage_s, kNotNegative, "How long it stays down; 0: never down",
                    Need::optional);
    }
};

struct BorderStiffeningSpec {
    static constexpr EffectRow kRow{"border_stiffening", ActsOn::carriedArray,
                                    "The cover is held from the sides, so taxels at the border are stiffer"};
    double share = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("share", share, NumberRange::between(0.0, 10.0),
                    "By how much the taxels of a border are stiffer; corners by twice that");
    }
};

/// The housing around the sensitive area, lower by recess_m, carries what presses on it and senses nothing.
struct HousingRimSpec {
    static constexpr EffectRow kRow{"housing_rim", ActsOn::carriedArray,
                                    "The housing around the taxels carries load and senses nothing"};
    double stiffness_NPerM = 2e5; ///< of a piece as long as a pitch
    double recess_m = 0.0005;
    double length_m = 0.050; ///< along x
    double width_m = 0.025;  ///< along y
    void describeKeys(Keys& keys, const core::ArrayLayout& layout);
};

/// The cover gives back less than it takes: beside each pressed spring k acts a damper k time_s.
struct ContactDampingSpec {
    static constexpr EffectRow kRow{"damping", ActsOn::carriedArray,
                                    "The cover gives back less than it takes"};
    double time_s = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("time_s", time_s, NumberRange::between(0.0, 1.0),
                    "Damping of the pressed cover over its stiffness");
    }
};

struct FrictionSpec {
    static constexpr EffectRow kRow{"friction", ActsOn::carriedArray,
                                    "The object rubs on the cover of the array"};
    double coefficient = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("coefficient", coefficient, NumberRange::between(0.0, 10.0),
                    "Coefficient of dry friction");
    }
};

/// k1..k6 and p1, p2 of vision::RationalDistortion. Without it the image is an ideal perspective of the same
/// focal length.
struct LensDistortionSpec {
    static constexpr EffectRow kRow{"lens_distortion", ActsOn::camera, "The lens is no pinhole"};
    std::array<double, 6> radial{};
    std::array<double, 2> tangential{};
    void describeKeys(Keys& keys);
};

struct MarkerPrintErrorSpec {
    static constexpr EffectRow kRow{"marker_print_error", ActsOn::camera,
                                    "Dots are printed beside their places and in other sizes"};
    double sd_m = 0.0;
    double sizeShare = 0.0; ///< standard deviation of the diameter as a share of it
    void describeKeys(Keys& keys) {
        keys.number("sd_m", sd_m, kNotNegative, "Standard deviation of a dot's place");
        keys.number("size_share", sizeShare, kNotNegative,
                    "Standard deviation of its diameter, as a share of it");
    }
};

struct UnevenLightSpec {
    static constexpr EffectRow kRow{"uneven_light", ActsOn::camera, "The lamps do not light the tube evenly"};
    int lamps = 8;
    double ripple = 0.0;
    double fallPerMetre = 0.0; ///< share that is lost a metre
    void describeKeys(Keys& keys) {
        keys.whole("lamps", lamps, {1, 100}, "Lamps around the tube");
        keys.number("ripple", ripple, kShare, "Share of the brightness that is lost between two lamps");
        keys.number("fall_per_m", fallPerMetre, kNotNegative,
                    "Share of the brightness that is lost along the tube");
    }
};

/// Darkness toward the corners of the image: 1 - share * (r / half diagonal)^2.
struct VignettingSpec {
    static constexpr EffectRow kRow{"vignetting", ActsOn::camera, "The image is darker toward its corners"};
    double share = 0.0;
    void describeKeys(Keys& keys) {
        keys.number("share", share, kShare, "Share of the brightness that is lost in the corners");
    }
};

struct MotionBlurSpec {
    static constexpr EffectRow kRow{"motion_blur", ActsOn::camera, "The shutter is open while things move"};
    double exposure_s = 0.0;
    int samples = 4; ///< moments that are averaged
    void describeKeys(Keys& keys) {
        keys.number("exposure_s", exposure_s, kPositive, "How long the shutter is open");
        keys.whole("samples", samples, {2, 32}, "Moments that a frame averages", Need::optional);
    }
};

/// Noise of the image sensor: variance read^2 + shot^2 * brightness, in grey levels of 255.
struct SensorNoiseSpec {
    static constexpr EffectRow kRow{"sensor_noise", ActsOn::camera, "The image sensor is noisy"};
    double read = 0.0;
    double shot = 0.0; ///< standard deviation at full brightness
    void describeKeys(Keys& keys) {
        keys.number("read", read, kNotNegative, "Standard deviation in the dark, in grey levels of 255");
        keys.number("shot", shot, kNotNegative,
                    "Standard deviation that is added at full brightness, in grey levels of 255");
    }
};

/// The table of effects. Those that act on the same thing act in this order, whatever the order in a scene.
using EffectParameters =
    std::variant<CrosstalkSpec, HysteresisSpec, NonlinearResponseSpec, GainSpreadSpec, DriftSpec, NoiseSpec,
                 SaturationSpec, QuantizationSpec, DeadTaxelsSpec, LatencySpec, GravityErrorSpec,
                 GearRippleSpec, TorqueNoiseSpec, EncoderQuantizationSpec, NonlinearObjectSpec, LinkDelaySpec,
                 BorderStiffeningSpec, HousingRimSpec, ContactDampingSpec, FrictionSpec, LensDistortionSpec,
                 MarkerPrintErrorSpec, UnevenLightSpec, VignettingSpec, MotionBlurSpec, SensorNoiseSpec>;

/// One imperfection that a scene calls for. What is not listed is not simulated.
struct Effect {
    std::string why; ///< what the scene would lose without it
    EffectParameters parameters;
};

/// The row of an effect's kind.
[[nodiscard]] const EffectRow& rowOf(const Effect& effect);
/// Its name in files, in summaries and of its random stream: "noise", "dead_taxels".
[[nodiscard]] inline std::string_view nameOf(const Effect& effect) {
    return rowOf(effect).name;
}

/// Describes the keys of one effect of a scene. canHave: what its effects can act on; layout: of its taxels;
/// earlier: the effects that it lists before this one.
void describeEffect(Keys& keys, Effect& effect, const std::vector<ActsOn>& canHave,
                    const core::ArrayLayout& layout, std::span<const Effect> earlier);

} // namespace teleta::scene
