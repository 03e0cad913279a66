// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <cmath>

namespace teleta::simulation {

/// Rounds each reading to the nearest multiple of a step.
TaxelEffect makeEffect(const Listed<scene::QuantizationSpec>& listed) {
    return {.name = listed.name(), .apply = [step_N = listed.spec.step_N](std::span<double> load_N) {
                for (double& value_N : load_N)
                    value_N = step_N * std::round(value_N / step_N);
            }};
}

} // namespace teleta::simulation
