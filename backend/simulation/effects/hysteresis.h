// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"

#include <vector>

namespace teleta::simulation {

/// The reading stays behind while the load falls: a play operator whose loading branch is the load itself and
/// whose unloading branch lies a share h above it. Independent of speed, 0 at no load.
///   y_k = min(max(y_(k-1), x_k), (1 + h) x_k)
/// Area of a full loop from 0 to X: X^2 h / (2 (1 + h)).
/// Source: A. Visintin, Differential Models of Hysteresis (1994), generalised play.
class Hysteresis : public Effect {
public:
    Hysteresis(std::string_view name, const scene::HysteresisSpec& spec, const core::ArrayLayout& layout);

    void apply(std::span<double> load_N) override;
    void restart() override;

private:
    scene::HysteresisSpec m_spec;
    std::vector<double> m_held_N;
};

} // namespace teleta::simulation
