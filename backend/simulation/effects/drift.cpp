// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/drift.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

Drift::Drift(std::string_view name, const scene::DriftSpec& spec, const core::ArrayLayout& layout,
             double step_s, RandomStream random)
    : Effect(name, EffectStage::readout)
    , m_keep(std::exp(-step_s / spec.timeConstant_s))
    // 1 - a^2 would cancel when the time constant is long.
    , m_kick_N(spec.sd_N * std::sqrt(-std::expm1(-2.0 * step_s / spec.timeConstant_s)))
    , m_rest_N(layout.taxels(), 0.0)
    , m_random(random) {
}

void Drift::apply(std::span<double> load_N) {
    for (std::size_t i = 0; i < load_N.size(); ++i) {
        m_rest_N[i] = m_keep * m_rest_N[i] + m_kick_N * m_random.normal();
        load_N[i] += m_rest_N[i];
    }
}

void Drift::restart() {
    std::ranges::fill(m_rest_N, 0.0);
    m_random.restart();
}

} // namespace teleta::simulation
