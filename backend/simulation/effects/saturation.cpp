// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/saturation.h"

#include <algorithm>

namespace teleta::simulation {

Saturation::Saturation(std::string_view name, double fullScale_N)
    : Effect(name, EffectStage::readout)
    , m_fullScale_N(fullScale_N) {
}

void Saturation::apply(std::span<double> load_N) {
    for (double& value_N : load_N)
        value_N = std::clamp(value_N, 0.0, m_fullScale_N);
}

} // namespace teleta::simulation
