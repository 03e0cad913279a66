// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/base/effect.h"
#include "backend/simulation/base/timed_effects.h"

#include <memory>
#include <span>
#include <vector>

namespace teleta::simulation {

/// What happens to the loads on an array's taxels until they are read:
///   skin effects -> firing threshold -> read-out effects
/// and the time that each effect takes. Thread: one; read() allocates nothing.
class EffectChain {
public:
    /// effects: in the order in which they act within their stage.
    explicit EffectChain(std::vector<std::unique_ptr<TaxelEffect>> effects);

    /// load_N: the array's taxels, changed in place; what is under the threshold does not fire and reads 0.
    void read(std::span<double> load_N, double firingThreshold_N);
    /// Forgets all frames and times.
    void restart() { m_effects.restart(); }
    /// Adds the times of the effects, in their order.
    void appendTimes(std::vector<EffectTime>& times) const { m_effects.appendTimes(times); }

private:
    void apply(EffectStage stage, std::span<double> load_N);

    TimedEffects<TaxelEffect> m_effects;
};

} // namespace teleta::simulation
