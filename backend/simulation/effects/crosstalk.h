// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"

#include <vector>

namespace teleta::simulation {

/// The elastic cover hands a share of each taxel's load to its four neighbours in equal parts.
///   out_i = (1 - n_i s/4) in_i + s/4 sum over the n_i neighbours of in_j
/// The total is conserved: at a border the part without a neighbour stays.
class Crosstalk : public Effect {
public:
    Crosstalk(std::string_view name, const scene::CrosstalkSpec& spec, const core::ArrayLayout& layout);

    void apply(std::span<double> load_N) override;

private:
    core::ArrayLayout m_layout;
    double m_toEach;
    std::vector<double> m_change_N;
};

} // namespace teleta::simulation
