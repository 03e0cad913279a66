// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/nonlinear_response.h"

#include <algorithm>

namespace teleta::simulation {

NonlinearResponse::NonlinearResponse(std::string_view name, const scene::NonlinearResponseSpec& spec,
                                     double fullScale_N)
    : Effect(name, EffectStage::readout)
    , m_bend(4.0 * spec.bow)
    , m_fullScale_N(fullScale_N) {
}

void NonlinearResponse::apply(std::span<double> load_N) {
    for (double& value_N : load_N) {
        const double within_N = std::clamp(value_N, 0.0, m_fullScale_N);
        const double beyond_N = value_N - within_N;
        const double slope = beyond_N > 0.0 ? 1.0 - m_bend : 1.0 + m_bend;
        value_N = within_N + m_bend * within_N * (1.0 - within_N / m_fullScale_N) + slope * beyond_N;
    }
}

} // namespace teleta::simulation
