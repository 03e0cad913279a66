// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/hysteresis.h"

#include <algorithm>

namespace teleta::simulation {

Hysteresis::Hysteresis(std::string_view name, const scene::HysteresisSpec& spec,
                       const core::ArrayLayout& layout)
    : Effect(name, EffectStage::skin)
    , m_spec(spec)
    , m_held_N(layout.taxels(), 0.0) {
}

void Hysteresis::apply(std::span<double> load_N) {
    for (std::size_t i = 0; i < load_N.size(); ++i) {
        m_held_N[i] = std::min(std::max(m_held_N[i], load_N[i]), (1.0 + m_spec.share) * load_N[i]);
        load_N[i] = m_held_N[i];
    }
}

void Hysteresis::restart() {
    std::ranges::fill(m_held_N, 0.0);
}

} // namespace teleta::simulation
