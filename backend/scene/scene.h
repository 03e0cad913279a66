// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/arm_world.h"
#include "backend/scene/array_world.h"
#include "backend/scene/camera_world.h"
#include "backend/scene/effects.h"
#include "backend/scene/gel_world.h"
#include "backend/scene/servo_world.h"

#include <string>
#include <variant>
#include <vector>

namespace teleta::scene {

/// A simulated world as its file describes it. SI units.
struct Scene {
    std::string name;
    std::string description;
    double duration_s = 0.0;
    /// Frames of an array or a camera, samples of an arm or control cycles of a servo, per second.
    double rate_Hz = 0.0;
    std::variant<ArrayWorld, ArmWorld, CameraWorld, ServoWorld, GelWorld> world;
    std::vector<Effect> effects; ///< each kind at most once

    /// Describes name, description, duration_s and rate_Hz.
    void describeHead(Keys& keys);
    /// Describes the tables of its kind of world.
    void describeWorld(Keys& keys);
    /// Describes the effects that this can have.
    void describeEffects(Keys& keys);

    [[nodiscard]] bool isArm() const { return std::holds_alternative<ArmWorld>(world); }
    /// An operator at another place drives the arm.
    [[nodiscard]] bool isTeleoperated() const {
        return isArm() && std::holds_alternative<OperatorProgram>(arm().program);
    }
    [[nodiscard]] bool isServo() const { return std::holds_alternative<ServoWorld>(world); }
    [[nodiscard]] bool isCamera() const { return std::holds_alternative<CameraWorld>(world); }
    [[nodiscard]] bool isGel() const { return std::holds_alternative<GelWorld>(world); }
    /// It has pictures rather than taxels.
    [[nodiscard]] bool isSeen() const { return isCamera() || isGel(); }
    /// The world of a scene of that kind; throws std::bad_variant_access with the other.
    [[nodiscard]] const ArrayWorld& array() const { return std::get<ArrayWorld>(world); }
    [[nodiscard]] ArrayWorld& array() { return std::get<ArrayWorld>(world); }
    [[nodiscard]] const ArmWorld& arm() const { return std::get<ArmWorld>(world); }
    [[nodiscard]] ArmWorld& arm() { return std::get<ArmWorld>(world); }
    [[nodiscard]] const CameraWorld& camera() const { return std::get<CameraWorld>(world); }
    [[nodiscard]] CameraWorld& camera() { return std::get<CameraWorld>(world); }
    [[nodiscard]] const GelWorld& gel() const { return std::get<GelWorld>(world); }
    [[nodiscard]] GelWorld& gel() { return std::get<GelWorld>(world); }
    [[nodiscard]] const ServoWorld& servo() const { return std::get<ServoWorld>(world); }
    [[nodiscard]] ServoWorld& servo() { return std::get<ServoWorld>(world); }
    /// What its effects can act on.
    [[nodiscard]] std::vector<ActsOn> canHave() const;
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
        if (isSeen())
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

/// Checks a scene that was made by a program rather than read from a file: every value against the range of
/// its key, and effects that the world cannot have.
/// Error: badInput; where.file is the path of the key, "indenter[0].radius_m".
[[nodiscard]] core::Expected<void> checkScene(const Scene& scene);

/// The same, and that the scene is of this kind.
[[nodiscard]] core::Expected<void> checkArrayScene(const Scene& scene);
[[nodiscard]] core::Expected<void> checkArmScene(const Scene& scene);
/// An arm with an operator.
[[nodiscard]] core::Expected<void> checkTeleoperatedScene(const Scene& scene);
[[nodiscard]] core::Expected<void> checkCameraScene(const Scene& scene);
[[nodiscard]] core::Expected<void> checkGelScene(const Scene& scene);
[[nodiscard]] core::Expected<void> checkServoScene(const Scene& scene);

} // namespace teleta::scene
