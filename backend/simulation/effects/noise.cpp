// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/noise.h"

namespace teleta::simulation {

Noise::Noise(std::string_view name, const scene::NoiseSpec& spec, RandomStream random)
    : Effect(name, EffectStage::readout)
    , m_spec(spec)
    , m_random(random) {
}

void Noise::apply(std::span<double> load_N) {
    for (double& value_N : load_N)
        value_N += m_spec.sd_N * m_random.normal();
}

void Noise::restart() {
    m_random.restart();
}

} // namespace teleta::simulation
