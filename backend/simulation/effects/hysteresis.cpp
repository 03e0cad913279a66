// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>

namespace teleta::simulation {

/// The reading stays behind while the load falls: a play operator whose loading branch is the load itself and
/// whose unloading branch lies a share h above it. Independent of speed, 0 at no load.
///   y_k = min(max(y_(k-1), x_k), (1 + h) x_k)
/// Area of a full loop from 0 to X: X^2 h / (2 (1 + h)).
/// Source: A. Visintin, Differential Models of Hysteresis (1994), generalised play.
TaxelEffect makeEffect(const Listed<scene::HysteresisSpec>& listed) {
    return {
        .name = listed.name(),
        .stage = EffectStage::skin,
        .apply = [share = listed.spec.share, held_N = std::vector<double>(listed.scene.taxels().taxels())](
                     std::span<double> load_N) mutable {
            for (std::size_t i = 0; i < load_N.size(); ++i) {
                held_N[i] = std::min(std::max(held_N[i], load_N[i]), (1.0 + share) * load_N[i]);
                load_N[i] = held_N[i];
            }
        }};
}

} // namespace teleta::simulation
