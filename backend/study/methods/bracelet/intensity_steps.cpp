// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/bracelet/intensity_steps.h"

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

/// More levels than any drive has.
constexpr std::size_t kMostSteps = 100'000;
/// Sums of steps are rounded.
constexpr double kStepRounding = 1e-12;

double jndAt(std::span<const JndAt> jnds, double level) {
    if (level <= jnds.front().level)
        return jnds.front().jnd;
    for (std::size_t i = 1; i < jnds.size(); ++i) {
        if (level < jnds[i].level) {
            const double share = (level - jnds[i - 1].level) / (jnds[i].level - jnds[i - 1].level);
            return jnds[i - 1].jnd + share * (jnds[i].jnd - jnds[i - 1].jnd);
        }
    }
    return jnds.back().jnd;
}

} // namespace

std::optional<std::vector<double>> intensitySteps(std::span<const JndAt> jnds, double start, double full) {
    const bool usable = !jnds.empty() && start <= full &&
                        std::ranges::all_of(jnds, [](const JndAt& one) { return one.jnd > 0.0; });
    if (!usable)
        return std::nullopt;
    std::vector<double> levels;
    for (double level = start; level <= full + kStepRounding && levels.size() < kMostSteps;
         level += jndAt(jnds, level))
        levels.push_back(level);
    return levels;
}

} // namespace teleta::study
