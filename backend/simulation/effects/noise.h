// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"
#include "backend/simulation/base/random_stream.h"

namespace teleta::simulation {

/// Adds Gaussian noise of a given standard deviation, independent in every taxel and frame. Readings may be
/// negative.
class Noise : public Effect {
public:
    Noise(std::string_view name, const scene::NoiseSpec& spec, RandomStream random);

    void apply(std::span<double> load_N) override;
    void restart() override;

private:
    scene::NoiseSpec m_spec;
    RandomStream m_random;
};

} // namespace teleta::simulation
