// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/servo/cycle_times.h"
#include "backend/servo/servo_controller.h"
#include "backend/simulation/servo/servo_world.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace teleta::simulation {

/// The plan of tasks that a scene's task stands for. The compliance of its tasks is that of the scene's arm
/// and of a row of its array in series.
[[nodiscard]] servo::ServoPlan servoPlan(const scene::Scene& scene);

/// How the frames of a servo scene become features: a taxel that has not fired is noise, so features run over
/// those that have.
[[nodiscard]] contact::FeatureSettings servoFeatures(const scene::Scene& scene);

/// The closed loop of a servo scene: world, image processing and servo, each at its own rate. One control
/// cycle a call:
///   arm and contact -> frame (acquisition) -> features (images) -> twist and reference pose (servo)
/// Each takes the newest of what is before it. Deterministic. Thread: one; next() allocates nothing.
class ServoLoop {
public:
    /// Error: badInput when the scene is not valid or not of a servo.
    [[nodiscard]] static core::Expected<std::unique_ptr<ServoLoop>> make(const scene::Scene& scene,
                                                                         std::uint64_t seed);

    void restart();
    /// hold: STOP; the reference becomes the measured pose and stays there.
    void next(bool hold = false);

    /// What happened in the last cycle.
    [[nodiscard]] bool frameCame() const { return m_frameCame; }
    [[nodiscard]] bool servoed() const { return m_servoed; }

    [[nodiscard]] const SimulatedServoWorld& world() const { return *m_world; }
    [[nodiscard]] const std::vector<float>& frame() const { return m_frame; }
    [[nodiscard]] const contact::TactileFeatures& features() const { return m_features; }
    [[nodiscard]] const servo::ServoOutput& output() const { return m_output; }
    /// Of the cycles since the start.
    [[nodiscard]] const servo::CycleTimes& times() const { return m_times; }
    [[nodiscard]] servo::ServoController& controller() { return m_controller; }

private:
    void cycle(bool hold, servo::CycleTimes* times);

    ServoLoop(const scene::Scene& scene, std::unique_ptr<SimulatedServoWorld> world,
              servo::ServoController controller);

    std::unique_ptr<SimulatedServoWorld> m_world;
    Schedule m_images;
    Schedule m_servo;
    double m_servoStep_s;
    contact::FeatureExtractor m_extractor;
    servo::ServoController m_controller;
    std::vector<float> m_frame;
    std::vector<float> m_load_N;
    contact::TactileFeatures m_features;
    servo::ServoOutput m_output;
    servo::CycleTimes m_times;
    std::uint64_t m_lastServo = 0;
    bool m_frameCame = false;
    bool m_frameWaits = false;
    bool m_servoed = false;
};

} // namespace teleta::simulation
