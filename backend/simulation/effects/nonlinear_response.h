// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/effect.h"

namespace teleta::simulation {

/// The reading is a parabola of the load x, exact at 0 and at full scale X:
///   y = x + 4 b x (1 - x/X),  0 <= x <= X
/// and goes on straight on both sides with the slope that it has there, 1 + 4 b and 1 - 4 b. Rises with the
/// load. Source: servoing paper, Fig. A.15.
class NonlinearResponse : public Effect {
public:
    NonlinearResponse(std::string_view name, const scene::NonlinearResponseSpec& spec, double fullScale_N);

    void apply(std::span<double> load_N) override;

private:
    double m_bend; ///< 4 b
    double m_fullScale_N;
};

} // namespace teleta::simulation
