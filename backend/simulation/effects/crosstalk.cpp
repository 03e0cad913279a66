// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/crosstalk.h"

#include <algorithm>

namespace teleta::simulation {

Crosstalk::Crosstalk(std::string_view name, const scene::CrosstalkSpec& spec, const core::ArrayLayout& layout)
    : Effect(name, EffectStage::skin)
    , m_layout(layout)
    , m_toEach(0.25 * spec.share)
    , m_change_N(layout.taxels()) {
}

void Crosstalk::apply(std::span<double> load_N) {
    std::ranges::fill(m_change_N, 0.0);
    const auto exchange = [&](std::size_t a, std::size_t b) {
        const double flow_N = m_toEach * (load_N[a] - load_N[b]);
        m_change_N[a] -= flow_N;
        m_change_N[b] += flow_N;
    };
    const auto columns = static_cast<std::size_t>(m_layout.columns);
    for (std::size_t i = 0; i < load_N.size(); ++i) {
        if ((i + 1) % columns != 0)
            exchange(i, i + 1);
        if (i + columns < load_N.size())
            exchange(i, i + columns);
    }
    for (std::size_t i = 0; i < load_N.size(); ++i)
        load_N[i] += m_change_N[i];
}

} // namespace teleta::simulation
