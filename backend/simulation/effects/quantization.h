// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"

namespace teleta::simulation {

/// Rounds each reading to the nearest multiple of a step.
class Quantization : public Effect {
public:
    Quantization(std::string_view name, const scene::QuantizationSpec& spec);

    void apply(std::span<double> load_N) override;

private:
    scene::QuantizationSpec m_spec;
};

} // namespace teleta::simulation
