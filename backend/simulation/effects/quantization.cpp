// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/quantization.h"

#include <cmath>

namespace teleta::simulation {

Quantization::Quantization(std::string_view name, const scene::QuantizationSpec& spec)
    : Effect(name, EffectStage::readout)
    , m_spec(spec) {
}

void Quantization::apply(std::span<double> load_N) {
    for (double& value_N : load_N)
        value_N = m_spec.step_N * std::round(value_N / m_spec.step_N);
}

} // namespace teleta::simulation
