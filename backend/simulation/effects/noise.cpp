// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

namespace teleta::simulation {

/// Adds Gaussian noise of a given standard deviation, independent in every taxel and frame. Readings may be
/// negative.
TaxelEffect makeEffect(const Listed<scene::NoiseSpec>& listed) {
    return {.name = listed.name(),
            .apply = [sd_N = listed.spec.sd_N, random = listed.random()](std::span<double> load_N) mutable {
                for (double& value_N : load_N)
                    value_N += sd_N * random.normal();
            }};
}

} // namespace teleta::simulation
