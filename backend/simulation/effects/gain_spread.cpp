// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/gain_spread.h"

#include "backend/simulation/base/listed_effects.h"

#include <cmath>

namespace teleta::simulation {

std::vector<double> gainFactors(const scene::GainSpreadSpec& spec, std::size_t taxels,
                                core::RandomStream random) {
    std::vector<double> factors(taxels);
    for (double& factor : factors)
        factor = std::exp(spec.sd * random.normal());
    return factors;
}

/// Multiplies the load of each taxel with its factor, the same in every frame.
TaxelEffect makeEffect(const Listed<scene::GainSpreadSpec>& listed) {
    return {.name = listed.name(),
            .apply = [factors = gainFactors(listed.spec, listed.scene.taxels().taxels(), listed.random())](
                         std::span<double> load_N) {
                for (std::size_t i = 0; i < load_N.size(); ++i)
                    load_N[i] *= factors[i];
            }};
}

} // namespace teleta::simulation
