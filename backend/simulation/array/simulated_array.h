// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/simulation/array/foundation_contact.h"
#include "backend/simulation/array/keyframe_motion.h"
#include "backend/simulation/array/rigid_indenter.h"
#include "backend/simulation/effects/effect_chain.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::simulation {

/// One indenter as it truly is in the newest frame.
struct IndenterTruth {
    std::string name;
    Pose pose;
    IndenterLoad load;
};

/// What the simulated world knows of the newest frame and no estimator may see.
struct ContactTruth {
    double motionTime_s = 0.0; ///< time of the motion; stands still while it is held
    std::vector<IndenterTruth> indenters;
};

/// The tactile array of a scene, pressed by the scene's indenters. One frame a call:
///   contact with the foundation -> skin effects (crosstalk, hysteresis) -> firing threshold
///   -> read-out effects (nonlinear response, drift, noise, saturation, quantization, dead taxels, latency)
/// Effects always act in this order, however the scene lists them. Only effects that the scene lists exist.
/// Deterministic: same scene, same seed, same frames.
/// Thread: one.
class SimulatedArray : public core::FrameGenerator {
public:
    /// Error: badInput when the scene is not valid (scene::checkArrayScene).
    [[nodiscard]] static core::Expected<std::unique_ptr<SimulatedArray>> make(const scene::Scene& scene,
                                                                              std::uint64_t seed);

    [[nodiscard]] core::SourceDescription description() const override { return m_description; }
    void next(std::span<float> values, bool motionHeld) override;
    [[nodiscard]] double time_s() const override {
        return static_cast<double>(m_frame) / m_description.nominalRate_Hz;
    }
    void restart() override;

    [[nodiscard]] const ContactTruth& truth() const { return m_truth; }
    [[nodiscard]] const std::vector<EffectTime>& effectTimes() const { return m_effects.times(); }

private:
    SimulatedArray(const scene::Scene& scene, std::uint64_t seed);

    core::SourceDescription m_description;
    double m_firingThreshold_N;
    FoundationContact m_contact;
    std::vector<KeyframeMotion> m_motions;
    std::vector<RigidIndenter> m_indenters;
    EffectChain m_effects;
    std::vector<double> m_load_N;
    std::vector<IndenterLoad> m_loads;
    ContactTruth m_truth;
    std::uint64_t m_frame = 0;
    std::uint64_t m_motionFrame = 0;
};

/// The frames of a scene's tactile array for a simulated device.
/// Error: badInput when the scene is not valid (scene::checkArrayScene).
[[nodiscard]] core::Expected<std::unique_ptr<core::FrameGenerator>>
makeTactileArray(const scene::Scene& scene, std::uint64_t seed);

} // namespace teleta::simulation
