// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/array/simulated_array.h"

#include "backend/simulation/base/listed_effects.h"

#include <algorithm>

namespace teleta::simulation {

core::Expected<std::unique_ptr<SimulatedArray>> SimulatedArray::make(const scene::Scene& scene,
                                                                     std::uint64_t seed) {
    TELETA_CHECK(checkArrayScene(scene));
    return std::unique_ptr<SimulatedArray>(new SimulatedArray(scene, seed));
}

SimulatedArray::SimulatedArray(const scene::Scene& scene, std::uint64_t seed)
    : m_description{.name = scene.name,
                    .layout = scene.array().sensor.layout,
                    .unit = "N",
                    .nominalRate_Hz = scene.rate_Hz,
                    .simulated = true}
    , m_firingThreshold_N(scene.array().sensor.firingThreshold_N)
    , m_contact(scene.array().sensor.layout, scene.array().sensor.stiffness_NPerM)
    , m_effects(makeEffects<scene::ActsOn::taxels>(scene, seed, 1.0 / scene.rate_Hz))
    , m_load_N(scene.array().sensor.layout.taxels())
    , m_loads(scene.array().indenters.size()) {
    for (const scene::Indenter& indenter : scene.array().indenters) {
        m_motions.emplace_back(indenter.keyframes, indenter.loop);
        m_indenters.emplace_back(indenter.shape);
        m_truth.indenters.push_back({.name = indenter.name, .pose = m_motions.back().at(0.0), .load = {}});
    }
}

void SimulatedArray::next(std::span<float> values, bool motionHeld) {
    ++m_frame;
    if (!motionHeld)
        ++m_motionFrame;
    m_truth.motionTime_s = static_cast<double>(m_motionFrame) / m_description.nominalRate_Hz;
    for (std::size_t i = 0; i < m_indenters.size(); ++i)
        m_indenters[i].moveTo(m_motions[i].at(m_truth.motionTime_s));

    m_contact.press(m_indenters, m_load_N, m_loads);
    for (std::size_t i = 0; i < m_indenters.size(); ++i) {
        m_truth.indenters[i].pose = m_indenters[i].pose();
        m_truth.indenters[i].load = m_loads[i];
    }
    m_effects.read(m_load_N, m_firingThreshold_N);
    std::ranges::transform(m_load_N, values.begin(),
                           [](double load_N) { return static_cast<float>(load_N); });
}

void SimulatedArray::restart() {
    m_frame = m_motionFrame = 0;
    m_effects.restart();
}

core::Expected<std::unique_ptr<core::FrameGenerator>> makeTactileArray(const scene::Scene& scene,
                                                                       std::uint64_t seed) {
    return SimulatedArray::make(scene, seed);
}

} // namespace teleta::simulation
