// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/latency.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

Latency::Latency(std::string_view name, const scene::LatencySpec& spec, const core::ArrayLayout& layout,
                 double step_s)
    : Effect(name, EffectStage::readout)
    , m_taxels(layout.taxels())
    , m_waiting_N(static_cast<std::size_t>(std::llround(spec.delay_s / step_s)) * m_taxels, 0.0) {
}

void Latency::apply(std::span<double> load_N) {
    if (m_waiting_N.empty())
        return;
    std::swap_ranges(load_N.begin(), load_N.end(), m_waiting_N.begin() + static_cast<std::ptrdiff_t>(m_next));
    m_next = (m_next + m_taxels) % m_waiting_N.size();
}

void Latency::restart() {
    std::ranges::fill(m_waiting_N, 0.0);
    m_next = 0;
}

} // namespace teleta::simulation
