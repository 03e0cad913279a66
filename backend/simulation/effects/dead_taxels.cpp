// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <numeric>
#include <utility>

namespace teleta::simulation {

/// Some taxels read one value whatever their load: named ones, or so many drawn from the random stream.
TaxelEffect makeEffect(const Listed<scene::DeadTaxelsSpec>& listed) {
    const core::ArrayLayout layout = listed.scene.taxels();
    std::vector<std::size_t> dead;
    for (const scene::TaxelIndex& taxel : listed.spec.taxels)
        dead.push_back(static_cast<std::size_t>(taxel.row) * static_cast<std::size_t>(layout.columns) +
                       static_cast<std::size_t>(taxel.column));
    if (dead.empty()) {
        core::RandomStream random = listed.random();
        dead.resize(layout.taxels());
        std::iota(dead.begin(), dead.end(), std::size_t{0});
        for (std::size_t i = 0; i < listed.spec.count; ++i)
            std::swap(dead[i], dead[i + random.below(dead.size() - i)]);
        dead.resize(listed.spec.count);
    }
    return {.name = listed.name(),
            .apply = [dead = std::move(dead), reading_N = listed.spec.reading_N](std::span<double> load_N) {
                for (const std::size_t taxel : dead)
                    load_N[taxel] = reading_N;
            }};
}

} // namespace teleta::simulation
