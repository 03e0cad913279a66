// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>

namespace teleta::simulation {

/// The elastic cover hands a share of each taxel's load to its four neighbours in equal parts.
///   out_i = (1 - n_i s/4) in_i + s/4 sum over the n_i neighbours of in_j
/// The total is conserved: at a border the part without a neighbour stays.
TaxelEffect makeEffect(const Listed<scene::CrosstalkSpec>& listed) {
    return {.name = listed.name(),
            .stage = EffectStage::skin,
            .apply = [columns = static_cast<std::size_t>(listed.scene.taxels().columns),
                      toEach = 0.25 * listed.spec.share,
                      change_N = std::vector<double>(listed.scene.taxels().taxels())](
                         std::span<double> load_N) mutable {
                std::ranges::fill(change_N, 0.0);
                const auto exchange = [&](std::size_t a, std::size_t b) {
                    const double flow_N = toEach * (load_N[a] - load_N[b]);
                    change_N[a] -= flow_N;
                    change_N[b] += flow_N;
                };
                for (std::size_t i = 0; i < load_N.size(); ++i) {
                    if ((i + 1) % columns != 0)
                        exchange(i, i + 1);
                    if (i + columns < load_N.size())
                        exchange(i, i + columns);
                }
                for (std::size_t i = 0; i < load_N.size(); ++i)
                    load_N[i] += change_N[i];
            }};
}

} // namespace teleta::simulation
