// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

/// Readings come late by whole frames, the number nearest to the delay.
///   y_k = x_(k-n),  n = round(delay / step),  0 before the first frame
TaxelEffect makeEffect(const Listed<scene::LatencySpec>& listed) {
    const auto frames = static_cast<std::size_t>(std::llround(listed.spec.delay_s / listed.step_s));
    // A ring of n frames; next: where the oldest one begins.
    return {.name = listed.name(),
            .apply = [waiting_N = std::vector<double>(frames * listed.scene.taxels().taxels()),
                      next = std::ptrdiff_t{0}](std::span<double> load_N) mutable {
                if (waiting_N.empty())
                    return;
                std::swap_ranges(load_N.begin(), load_N.end(), waiting_N.begin() + next);
                next = (next + std::ssize(load_N)) % std::ssize(waiting_N);
            }};
}

} // namespace teleta::simulation
