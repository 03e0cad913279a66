// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/random_stream.h"
#include "backend/scene/scene.h"
#include "backend/simulation/base/timed_effects.h"
#include "backend/simulation/effects/effect_chain.h"
#include "backend/simulation/servo/impedance_arm.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace teleta::simulation {

/// Events of a rate within the cycles of a higher one, spread evenly: event k happens in the first cycle n
/// with n rate/cycleRate >= k. A rate that is higher than that of the cycles happens in each of them.
class Schedule {
public:
    Schedule(double rate_Hz, double cycleRate_Hz)
        : m_perCycle(rate_Hz < cycleRate_Hz ? rate_Hz / cycleRate_Hz : 1.0) {}

    /// cycle: 1, 2, ...
    [[nodiscard]] bool isDue(std::uint64_t cycle) const { return events(cycle) != events(cycle - 1); }

private:
    /// The small amount keeps a rate that divides the other one exactly in its own cycles.
    [[nodiscard]] std::uint64_t events(std::uint64_t cycle) const {
        return static_cast<std::uint64_t>(static_cast<double>(cycle) * m_perCycle + 1e-9);
    }

    double m_perCycle;
};

/// What the world knows of the newest cycle and no estimator may see.
struct ServoTruth {
    double time_s = 0.0;
    double force_N =
        0.0; ///< all that presses the array and its housing along -z, as a force sensor behind it
    bool touching = false;
    double hinge_rad = 0.0;   ///< how far the tray has tipped
    double massPlace_m = 0.0; ///< of the mass on the tray
};

/// And of the newest frame: the loads before any effect of the sensor.
struct ServoFrameTruth {
    ArrayLoads loads;
    Eigen::Isometry3d X_Base_Sensor = Eigen::Isometry3d::Identity();
    /// Direction of the line of contact in {s}, (-pi/2, pi/2]; empty for a ball or a wall.
    std::optional<double> alphaZ_rad;
};

/// The seven-joint arm with the tactile array in its hand and the object in front of it. One control cycle a
/// call; the reference pose is what a servo commands. Effects act on a frame in the order of SimulatedArray;
/// the housing and stiffer borders are part of the contact. Only effects that the scene lists exist.
/// Deterministic: same scene, seed and references, same frames. Thread: one; next() and frame() allocate
/// nothing.
class SimulatedServoWorld {
public:
    /// Error: badInput when the scene is not valid or of another kind (scene::checkServoScene).
    [[nodiscard]] static core::Expected<std::unique_ptr<SimulatedServoWorld>> make(const scene::Scene& scene,
                                                                                   std::uint64_t seed);

    /// Everything as at the start.
    void restart();
    void setReference(const Eigen::Isometry3d& X_Base_Sensor) { m_arm.setReference(X_Base_Sensor); }
    /// times: null, or what the parts take is added there.
    void next(servo::CycleTimes* times = nullptr);

    /// True when the last cycle has read the array; its taxels, layout().taxels() values.
    [[nodiscard]] bool frame(std::span<float> load_N) const;

    [[nodiscard]] double time_s() const { return static_cast<double>(m_cycle) * m_step_s; }
    [[nodiscard]] std::uint64_t cycle() const { return m_cycle; }
    [[nodiscard]] double rate_Hz() const { return 1.0 / m_step_s; }
    [[nodiscard]] const core::ArrayLayout& layout() const { return m_arm.array().layout(); }
    [[nodiscard]] const ImpedanceArm& arm() const { return m_arm; }
    [[nodiscard]] const ServoTruth& truth() const { return m_truth; }
    [[nodiscard]] const ServoFrameTruth& frameTruth() const { return m_frameTruth; }
    /// Distance of a point of the base from the object's line of contact, or its surface when it has none.
    [[nodiscard]] double contourDistance_m(const Eigen::Vector3d& p_Base) const;
    /// The object's outward normal in {base} at a point in it or near it.
    [[nodiscard]] Eigen::Vector3d objectNormal_Base(const Eigen::Vector3d& p_Base) const;
    [[nodiscard]] std::vector<EffectTime> effectTimes() const;

private:
    SimulatedServoWorld(const scene::Scene& scene, std::uint64_t seed);
    void moveMass();
    void readArray(servo::CycleTimes* times);
    void updateTruth();

    scene::ServoWorld m_world;
    double m_step_s;
    Schedule m_acquisition;
    ImpedanceArm m_arm;
    EffectChain m_effects;
    std::vector<std::string_view> m_contactEffects; ///< part of the contact, which is not timed apart
    std::uint64_t m_cycle = 0;
    bool m_frameDue = false;
    std::vector<double> m_load_N;
    ServoTruth m_truth;
    ServoFrameTruth m_frameTruth;
};

} // namespace teleta::simulation
