// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"

#include <cstddef>
#include <vector>

namespace teleta::simulation {

/// Readings come late by whole frames, the number nearest to the delay.
///   y_k = x_(k-n),  n = round(delay / step),  0 before the first frame
class Latency : public Effect {
public:
    Latency(std::string_view name, const scene::LatencySpec& spec, const core::ArrayLayout& layout,
            double step_s);

    void apply(std::span<double> load_N) override;
    void restart() override;

private:
    std::size_t m_taxels;
    std::vector<double> m_waiting_N; ///< n frames, one after another, around
    std::size_t m_next = 0;          ///< where the oldest one begins
};

} // namespace teleta::simulation
