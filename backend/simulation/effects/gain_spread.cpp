// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/gain_spread.h"

#include <cmath>
#include <utility>

namespace teleta::simulation {

std::vector<double> gainFactors(const scene::GainSpreadSpec& spec, std::size_t taxels, RandomStream random) {
    std::vector<double> factors(taxels);
    for (double& factor : factors)
        factor = std::exp(spec.sd * random.normal());
    return factors;
}

GainSpread::GainSpread(std::string_view name, std::vector<double> factors)
    : Effect(name, EffectStage::readout)
    , m_factors(std::move(factors)) {
}

void GainSpread::apply(std::span<double> load_N) {
    for (std::size_t i = 0; i < load_N.size(); ++i)
        load_N[i] *= m_factors[i];
}

} // namespace teleta::simulation
