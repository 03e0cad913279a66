// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/simulated_array.h"

#include "backend/simulation/effects/effect_factory.h"

#include <algorithm>
#include <chrono>

namespace teleta::simulation {

core::Expected<std::unique_ptr<SimulatedArray>> SimulatedArray::make(const scene::Scene& scene,
                                                                     std::uint64_t seed) {
    if (const auto valid = checkArrayScene(scene); !valid)
        return core::Unexpected(valid.error());
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
    , m_load_N(scene.array().sensor.layout.taxels())
    , m_loads(scene.array().indenters.size()) {
    for (const scene::Indenter& indenter : scene.array().indenters) {
        m_motions.emplace_back(indenter.keyframes, indenter.loop);
        m_indenters.emplace_back(indenter.shape);
        m_truth.indenters.push_back({.name = indenter.name, .pose = m_motions.back().at(0.0), .load = {}});
    }
    for (std::unique_ptr<Effect>& effect : makeEffects(scene, scene.rate_Hz, seed))
        m_effects.push_back({.effect = std::move(effect)});
}

core::SourceDescription SimulatedArray::description() const {
    return m_description;
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
    applyEffects(EffectStage::skin);
    for (double& load_N : m_load_N)
        load_N = load_N < m_firingThreshold_N ? 0.0 : load_N;
    applyEffects(EffectStage::readout);
    std::ranges::transform(m_load_N, values.begin(),
                           [](double load_N) { return static_cast<float>(load_N); });
}

void SimulatedArray::applyEffects(EffectStage stage) {
    using Clock = std::chrono::steady_clock;
    for (TimedEffect& timed : m_effects) {
        if (timed.effect->stage() != stage)
            continue;
        const Clock::time_point start = Clock::now();
        timed.effect->apply(m_load_N);
        timed.time_s += std::chrono::duration<double>(Clock::now() - start).count();
    }
}

double SimulatedArray::time_s() const {
    return static_cast<double>(m_frame) / m_description.nominalRate_Hz;
}

void SimulatedArray::restart() {
    m_frame = m_motionFrame = 0;
    for (TimedEffect& timed : m_effects) {
        timed.effect->restart();
        timed.time_s = 0.0;
    }
}

std::vector<EffectTime> SimulatedArray::effectTimes() const {
    std::vector<EffectTime> times;
    for (const TimedEffect& timed : m_effects)
        times.push_back({.name = timed.effect->name(), .time_s = timed.time_s});
    return times;
}

core::Expected<std::unique_ptr<core::FrameGenerator>> makeTactileArray(const scene::Scene& scene,
                                                                       std::uint64_t seed) {
    return SimulatedArray::make(scene, seed).map([](std::unique_ptr<SimulatedArray>&& array) {
        return std::unique_ptr<core::FrameGenerator>(std::move(array));
    });
}

} // namespace teleta::simulation
