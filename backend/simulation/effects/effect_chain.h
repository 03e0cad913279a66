// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/base/effect.h"
#include "backend/simulation/base/timed_effects.h"

#include <span>

namespace teleta::simulation {

/// What happens to the loads on an array's taxels until they are read:
///   skin effects -> firing threshold -> read-out effects
/// The effects act in their order within each stage. Thread: one; read() allocates nothing.
class EffectChain : public TimedEffects<TaxelEffect> {
public:
    using TimedEffects::TimedEffects;

    /// load_N: the array's taxels, changed in place; what is under the threshold does not fire and reads 0.
    void read(std::span<double> load_N, double firingThreshold_N) {
        act(EffectStage::skin, load_N);
        for (double& taxel_N : load_N)
            taxel_N = taxel_N < firingThreshold_N ? 0.0 : taxel_N;
        act(EffectStage::readout, load_N);
    }

private:
    void act(EffectStage stage, std::span<double> load_N) {
        apply([stage](const TaxelEffect& effect) { return effect.stage == stage; },
              [load_N](TaxelEffect& effect) { effect.apply(load_N); });
    }
};

} // namespace teleta::simulation
