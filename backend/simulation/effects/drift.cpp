// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <cmath>

namespace teleta::simulation {

/// Rest values that wander from 0: in each taxel an Ornstein-Uhlenbeck process, exact for any step.
///   b_(k+1) = a b_k + sd sqrt(1 - a^2) n,  a = exp(-dt/tau),  b_0 = 0,  variance sd^2 (1 - exp(-2 t/tau))
TaxelEffect makeEffect(const Listed<scene::DriftSpec>& listed) {
    const double keep = std::exp(-listed.step_s / listed.spec.timeConstant_s);
    // 1 - a^2 would cancel when the time constant is long.
    const double kick_N =
        listed.spec.sd_N * std::sqrt(-std::expm1(-2.0 * listed.step_s / listed.spec.timeConstant_s));
    return {.name = listed.name(),
            .apply = [keep, kick_N, rest_N = std::vector<double>(listed.scene.taxels().taxels()),
                      random = listed.random()](std::span<double> load_N) mutable {
                for (std::size_t i = 0; i < load_N.size(); ++i) {
                    rest_N[i] = keep * rest_N[i] + kick_N * random.normal();
                    load_N[i] += rest_N[i];
                }
            }};
}

} // namespace teleta::simulation
