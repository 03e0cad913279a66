// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"
#include "backend/simulation/base/random_stream.h"

#include <vector>

namespace teleta::simulation {

/// Rest values that wander from 0: in each taxel an Ornstein-Uhlenbeck process, exact for any step.
///   b_(k+1) = a b_k + sd sqrt(1 - a^2) n,  a = exp(-dt/tau),  b_0 = 0,  variance sd^2 (1 - exp(-2 t/tau))
class Drift : public Effect {
public:
    Drift(std::string_view name, const scene::DriftSpec& spec, const core::ArrayLayout& layout, double step_s,
          RandomStream random);

    void apply(std::span<double> load_N) override;
    void restart() override;

private:
    double m_keep;   ///< a
    double m_kick_N; ///< sd sqrt(1 - a^2)
    std::vector<double> m_rest_N;
    RandomStream m_random;
};

} // namespace teleta::simulation
