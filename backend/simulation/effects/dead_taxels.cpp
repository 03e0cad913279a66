// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/dead_taxels.h"

#include <numeric>
#include <utility>

namespace teleta::simulation {

DeadTaxels::DeadTaxels(std::string_view name, const scene::DeadTaxelsSpec& spec,
                       const core::ArrayLayout& layout, RandomStream random)
    : Effect(name, EffectStage::readout)
    , m_reading_N(spec.reading_N) {
    for (const scene::TaxelIndex& taxel : spec.taxels)
        m_dead.push_back(static_cast<std::size_t>(taxel.row) * static_cast<std::size_t>(layout.columns) +
                         static_cast<std::size_t>(taxel.column));
    if (!spec.taxels.empty())
        return;
    m_dead.resize(layout.taxels());
    std::iota(m_dead.begin(), m_dead.end(), std::size_t{0});
    for (std::size_t i = 0; i < spec.count; ++i)
        std::swap(m_dead[i], m_dead[i + random.below(m_dead.size() - i)]);
    m_dead.resize(spec.count);
}

void DeadTaxels::apply(std::span<double> load_N) {
    for (const std::size_t taxel : m_dead)
        load_N[taxel] = m_reading_N;
}

} // namespace teleta::simulation
