// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"
#include "backend/simulation/base/random_stream.h"

#include <vector>

namespace teleta::simulation {

/// Some taxels read one value whatever their load: named ones, or so many drawn from the random stream.
class DeadTaxels : public Effect {
public:
    DeadTaxels(std::string_view name, const scene::DeadTaxelsSpec& spec, const core::ArrayLayout& layout,
               RandomStream random);

    void apply(std::span<double> load_N) override;

private:
    std::vector<std::size_t> m_dead;
    double m_reading_N;
};

} // namespace teleta::simulation
