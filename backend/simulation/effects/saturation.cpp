// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>

namespace teleta::simulation {

/// Limits each reading to 0 .. full scale.
TaxelEffect makeEffect(const Listed<scene::SaturationSpec>& listed) {
    return {.name = listed.name(),
            .apply = [fullScale_N = listed.scene.fullScale_N()](std::span<double> load_N) {
                for (double& value_N : load_N)
                    value_N = std::clamp(value_N, 0.0, fullScale_N);
            }};
}

} // namespace teleta::simulation
