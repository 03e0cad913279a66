// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene.h"

#include "backend/core/data/range_check.h"
#include "backend/scene/arm_world_check.h"
#include "backend/scene/camera_world_check.h"
#include "backend/scene/servo_world_reader.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>

namespace teleta::scene {

namespace {

struct SceneCheck {
    Q_DECLARE_TR_FUNCTIONS(Scene)
};

bool isValid(const core::ArrayLayout& layout) {
    const auto side = [](int taxels) { return taxels >= 1 && taxels <= core::ArrayLayout::kMaximumSide; };
    return side(layout.rows) && side(layout.columns) && core::isPositive(layout.pitch_m);
}

struct ShapeIsValid {
    bool operator()(const Sphere& shape) const { return core::isPositive(shape.radius_m); }
    bool operator()(const Cylinder& shape) const {
        return core::isPositive(shape.radius_m) && core::isPositive(shape.length_m);
    }
    bool operator()(const BoxEdge& shape) const { return core::isPositive(shape.length_m); }
    bool operator()(const FlatPunch& shape) const {
        return core::isPositive(shape.length_m) && core::isPositive(shape.width_m);
    }
};

bool isValid(const std::vector<Keyframe>& keyframes) {
    const auto isFinite = [](const Keyframe& frame) {
        return std::isfinite(frame.time_s) && std::isfinite(frame.x_m) && std::isfinite(frame.y_m) &&
               std::isfinite(frame.depth_m) && std::isfinite(frame.angle_rad);
    };
    return !keyframes.empty() && std::ranges::all_of(keyframes, isFinite) &&
           std::ranges::adjacent_find(keyframes, std::ranges::greater_equal{}, &Keyframe::time_s) ==
               keyframes.end();
}

struct EffectIsValid {
    core::ArrayLayout layout;

    bool operator()(const NoiseSpec& spec) const { return core::isNotNegative(spec.sd_N); }
    bool operator()(const QuantizationSpec& spec) const { return core::isPositive(spec.step_N); }
    bool operator()(const SaturationSpec&) const { return true; }
    bool operator()(const DeadTaxelsSpec& spec) const {
        return spec.count <= layout.taxels() &&
               std::ranges::all_of(spec.taxels, [this](const TaxelIndex& taxel) {
                   return taxel.row >= 0 && taxel.row < layout.rows && taxel.column >= 0 &&
                          taxel.column < layout.columns;
               });
    }
    bool operator()(const CrosstalkSpec& spec) const {
        return core::isNotNegative(spec.share) && spec.share <= 1.0;
    }
    bool operator()(const HysteresisSpec& spec) const { return core::isNotNegative(spec.share); }
    bool operator()(const DriftSpec& spec) const {
        return core::isNotNegative(spec.sd_N) && core::isPositive(spec.timeConstant_s);
    }
    bool operator()(const LatencySpec& spec) const {
        return core::isNotNegative(spec.delay_s) && spec.delay_s <= 1.0;
    }
    bool operator()(const NonlinearResponseSpec& spec) const { return std::abs(spec.bow) <= 0.25; }
    bool operator()(const GainSpreadSpec& spec) const { return core::isNotNegative(spec.sd) && spec.sd <= 1.0; }
    bool operator()(const TorqueNoiseSpec& spec) const { return core::isNotNegative(spec.sd_Nm); }
    bool operator()(const EncoderQuantizationSpec& spec) const { return core::isPositive(spec.step_rad); }
    bool operator()(const GravityErrorSpec& spec) const { return std::isfinite(spec.share); }
    bool operator()(const GearRippleSpec& spec) const {
        return core::isNotNegative(spec.amplitude_Nm) && core::isPositive(spec.wavesPerTurn);
    }
    bool operator()(const NonlinearObjectSpec& spec) const { return core::isPositive(spec.doublingDepth_m); }
    bool operator()(const LinkDelaySpec& spec) const {
        return core::isNotNegative(spec.delay_s) && core::isNotNegative(spec.jitter_s) && core::isNotNegative(spec.lossShare) &&
               spec.lossShare <= 1.0 && core::isNotNegative(spec.outageAt_s) && core::isNotNegative(spec.outage_s);
    }
    bool operator()(const BorderStiffeningSpec& spec) const { return core::isNotNegative(spec.share); }
    bool operator()(const HousingRimSpec& spec) const {
        return core::isPositive(spec.stiffness_NPerM) && core::isNotNegative(spec.recess_m) &&
               core::isPositive(spec.length_m) && core::isPositive(spec.width_m);
    }
    bool operator()(const ContactDampingSpec& spec) const { return core::isNotNegative(spec.time_s); }
    bool operator()(const FrictionSpec& spec) const { return core::isNotNegative(spec.coefficient); }
    bool operator()(const LensDistortionSpec& spec) const { return isCameraEffect(spec); }
    bool operator()(const UnevenLightSpec& spec) const { return isCameraEffect(spec); }
    bool operator()(const SensorNoiseSpec& spec) const { return isCameraEffect(spec); }
    bool operator()(const MotionBlurSpec& spec) const { return isCameraEffect(spec); }
    bool operator()(const MarkerPrintErrorSpec& spec) const { return isCameraEffect(spec); }
    bool operator()(const VignettingSpec& spec) const { return isCameraEffect(spec); }
};

struct EffectName {
    std::string_view operator()(const NoiseSpec&) const { return "noise"; }
    std::string_view operator()(const QuantizationSpec&) const { return "quantization"; }
    std::string_view operator()(const SaturationSpec&) const { return "saturation"; }
    std::string_view operator()(const DeadTaxelsSpec&) const { return "dead_taxels"; }
    std::string_view operator()(const CrosstalkSpec&) const { return "crosstalk"; }
    std::string_view operator()(const HysteresisSpec&) const { return "hysteresis"; }
    std::string_view operator()(const DriftSpec&) const { return "drift"; }
    std::string_view operator()(const LatencySpec&) const { return "latency"; }
    std::string_view operator()(const NonlinearResponseSpec&) const { return "nonlinear_response"; }
    std::string_view operator()(const GainSpreadSpec&) const { return "gain_spread"; }
    std::string_view operator()(const TorqueNoiseSpec&) const { return "torque_noise"; }
    std::string_view operator()(const EncoderQuantizationSpec&) const { return "encoder_quantization"; }
    std::string_view operator()(const GravityErrorSpec&) const { return "gravity_error"; }
    std::string_view operator()(const GearRippleSpec&) const { return "gear_ripple"; }
    std::string_view operator()(const NonlinearObjectSpec&) const { return "nonlinear_object"; }
    std::string_view operator()(const LinkDelaySpec&) const { return "link_delay"; }
    std::string_view operator()(const BorderStiffeningSpec&) const { return "border_stiffening"; }
    std::string_view operator()(const HousingRimSpec&) const { return "housing_rim"; }
    std::string_view operator()(const ContactDampingSpec&) const { return "damping"; }
    std::string_view operator()(const FrictionSpec&) const { return "friction"; }
    std::string_view operator()(const LensDistortionSpec&) const { return "lens_distortion"; }
    std::string_view operator()(const UnevenLightSpec&) const { return "uneven_light"; }
    std::string_view operator()(const SensorNoiseSpec&) const { return "sensor_noise"; }
    std::string_view operator()(const MotionBlurSpec&) const { return "motion_blur"; }
    std::string_view operator()(const MarkerPrintErrorSpec&) const { return "marker_print_error"; }
    std::string_view operator()(const VignettingSpec&) const { return "vignetting"; }
};

core::Expected<void> refused(const QString& message) {
    return core::Unexpected(core::Error{core::ErrorKind::badInput, message.toStdString(), {}, {}});
}

core::Expected<void> checkWorld(const ArrayWorld& world) {
    const ArraySensor& sensor = world.sensor;
    if (!isValid(sensor.layout))
        return refused(SceneCheck::tr("the size of the tactile array is out of range"));
    if (!core::isPositive(sensor.stiffness_NPerM) || !core::isPositive(sensor.fullScale_N) ||
        !core::isNotNegative(sensor.firingThreshold_N))
        return refused(SceneCheck::tr("a property of the tactile array is out of range"));
    for (const Indenter& indenter : world.indenters) {
        const QString name = QString::fromStdString(indenter.name);
        if (!std::visit(ShapeIsValid(), indenter.shape))
            return refused(SceneCheck::tr("the size of indenter \"%1\" is out of range").arg(name));
        if (!isValid(indenter.keyframes))
            return refused(
                SceneCheck::tr("the motion of indenter \"%1\" is not a series of rising times").arg(name));
    }
    return {};
}

core::Expected<void> checkWorld(const ArmWorld& world) {
    const ArmWorldCheck check = checkArmWorld(world);
    switch (check.fault) {
    case ArmWorldFault::none:
        return {};
    case ArmWorldFault::body:
        return refused(SceneCheck::tr("a property of the arm is out of range"));
    case ArmWorldFault::control:
        return refused(SceneCheck::tr("a property of the joint controllers is out of range"));
    case ArmWorldFault::skin:
        return refused(SceneCheck::tr("a property of the arm's skin is out of range"));
    case ArmWorldFault::object:
        return refused(SceneCheck::tr("a property of object \"%1\" is out of range")
                           .arg(QString::fromStdString(world.objects[check.object].name)));
    case ArmWorldFault::unknown:
        return refused(SceneCheck::tr("how far the objects may be displaced is out of range"));
    case ArmWorldFault::program:
        break;
    }
    return refused(SceneCheck::tr("the program of the arm is out of range"));
}

core::Expected<void> checkWorld(const CameraWorld& world) {
    switch (checkCameraWorld(world)) {
    case CameraWorldFault::none:
        return {};
    case CameraWorldFault::camera:
        return refused(SceneCheck::tr("a property of the camera is out of range"));
    case CameraWorldFault::skin:
        return refused(SceneCheck::tr("a property of the soft tube is out of range"));
    case CameraWorldFault::finger:
        return refused(SceneCheck::tr("a finger's size or motion is out of range"));
    case CameraWorldFault::probing:
        return refused(SceneCheck::tr("a number of the probing is out of range"));
    case CameraWorldFault::arm:
        break;
    }
    return refused(SceneCheck::tr("what the arm under the soft tube does is out of range"));
}

core::Expected<void> checkWorld(const ServoWorld& world) {
    if (!isValidServoWorld(world))
        return refused(
            SceneCheck::tr("a property of the servoing arm, its sensor, object or task is out of range"));
    return {};
}

} // namespace

std::string_view nameOf(const Effect& effect) {
    return std::visit(EffectName(), effect.parameters);
}

core::Expected<void> checkScene(const Scene& scene) {
    if (!core::isPositive(scene.rate_Hz))
        return refused(SceneCheck::tr("the frame rate of the scene is not a positive number"));
    const core::Expected<void> world =
        std::visit([](const auto& known) { return checkWorld(known); }, scene.world);
    if (!world)
        return world;
    for (auto effect = scene.effects.begin(); effect != scene.effects.end(); ++effect) {
        const QString name = QString::fromUtf8(nameOf(*effect).data());
        if (!std::visit(EffectIsValid{scene.taxels()}, effect->parameters))
            return refused(SceneCheck::tr("a parameter of effect \"%1\" is out of range").arg(name));
        if (scene.isCamera() != (effect->parameters.index() >= kFirstCameraEffect))
            return refused(scene.isCamera() ? SceneCheck::tr("a camera has no effect \"%1\"").arg(name)
                                            : SceneCheck::tr("effect \"%1\" needs a camera").arg(name));
        const std::size_t kind = effect->parameters.index();
        if (!scene.isCamera() && kind >= kTaxelEffectKinds) {
            const bool ofArm = kind < kTaxelEffectKinds + kArmEffectKinds;
            if (ofArm && !scene.isArm())
                return refused(SceneCheck::tr("effect \"%1\" needs an arm").arg(name));
            if (!ofArm && !scene.isServo())
                return refused(SceneCheck::tr("effect \"%1\" needs a servoing arm").arg(name));
        }
        if (std::holds_alternative<LinkDelaySpec>(effect->parameters) && !scene.isTeleoperated())
            return refused(SceneCheck::tr("effect \"%1\" needs the program of an operator").arg(name));
        const bool again = std::any_of(scene.effects.begin(), effect, [&](const Effect& earlier) {
            return earlier.parameters.index() == effect->parameters.index();
        });
        if (again)
            return refused(SceneCheck::tr("effect \"%1\" is listed twice").arg(name));
    }
    return {};
}

core::Expected<void> checkArrayScene(const Scene& scene) {
    if (!std::holds_alternative<ArrayWorld>(scene.world))
        return refused(SceneCheck::tr("the scene is not that of a tactile array"));
    return checkScene(scene);
}

core::Expected<void> checkArmScene(const Scene& scene) {
    if (!scene.isArm())
        return refused(SceneCheck::tr("the scene is not that of an arm"));
    return checkScene(scene);
}

core::Expected<void> checkTeleoperatedScene(const Scene& scene) {
    if (!scene.isTeleoperated())
        return refused(SceneCheck::tr("the scene is not that of an arm with an operator"));
    return checkScene(scene);
}

core::Expected<void> checkCameraScene(const Scene& scene) {
    if (!scene.isCamera())
        return refused(SceneCheck::tr("the scene is not that of a camera in a soft tube"));
    return checkScene(scene);
}

core::Expected<void> checkServoScene(const Scene& scene) {
    if (!scene.isServo())
        return refused(SceneCheck::tr("the scene is not that of a servoing arm"));
    return checkScene(scene);
}

} // namespace teleta::scene
