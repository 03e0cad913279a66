// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/effect_chain.h"

#include <utility>

namespace teleta::simulation {

EffectChain::EffectChain(std::vector<std::unique_ptr<TaxelEffect>> effects)
    : m_effects(std::move(effects)) {
}

void EffectChain::read(std::span<double> load_N, double firingThreshold_N) {
    apply(EffectStage::skin, load_N);
    for (double& taxel_N : load_N)
        taxel_N = taxel_N < firingThreshold_N ? 0.0 : taxel_N;
    apply(EffectStage::readout, load_N);
}

void EffectChain::apply(EffectStage stage, std::span<double> load_N) {
    m_effects.apply([stage](const TaxelEffect& effect) { return effect.stage() == stage; },
                    [load_N](TaxelEffect& effect) { effect.apply(load_N); });
}

} // namespace teleta::simulation
