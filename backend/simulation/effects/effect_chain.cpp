// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/effect_chain.h"

#include <chrono>
#include <utility>

namespace teleta::simulation {

EffectChain::EffectChain(std::vector<std::unique_ptr<Effect>> effects) {
    for (std::unique_ptr<Effect>& effect : effects)
        m_effects.push_back({.effect = std::move(effect)});
}

void EffectChain::read(std::span<double> load_N, double firingThreshold_N) {
    apply(EffectStage::skin, load_N);
    for (double& taxel_N : load_N)
        taxel_N = taxel_N < firingThreshold_N ? 0.0 : taxel_N;
    apply(EffectStage::readout, load_N);
}

void EffectChain::apply(EffectStage stage, std::span<double> load_N) {
    using Clock = std::chrono::steady_clock;
    for (TimedEffect& timed : m_effects) {
        if (timed.effect->stage() != stage)
            continue;
        const Clock::time_point start = Clock::now();
        timed.effect->apply(load_N);
        timed.time_s += std::chrono::duration<double>(Clock::now() - start).count();
    }
}

void EffectChain::restart() {
    for (TimedEffect& timed : m_effects) {
        timed.effect->restart();
        timed.time_s = 0.0;
    }
}

void EffectChain::appendTimes(std::vector<EffectTime>& times) const {
    for (const TimedEffect& timed : m_effects)
        times.push_back({.name = timed.effect->name(), .time_s = timed.time_s});
}

} // namespace teleta::simulation
