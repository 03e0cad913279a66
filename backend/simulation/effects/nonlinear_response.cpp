// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/listed_effects.h"

#include <algorithm>

namespace teleta::simulation {

/// The reading is a parabola of the load x, exact at 0 and at full scale X:
///   y = x + 4 b x (1 - x/X),  0 <= x <= X
/// and goes on straight on both sides with the slope that it has there, 1 + 4 b and 1 - 4 b. Rises with the
/// load. Source: servoing paper, Fig. A.15.
TaxelEffect makeEffect(const Listed<scene::NonlinearResponseSpec>& listed) {
    return {.name = listed.name(),
            .apply = [bend = 4.0 * listed.spec.bow,
                      fullScale_N = listed.scene.fullScale_N()](std::span<double> load_N) {
                for (double& value_N : load_N) {
                    const double within_N = std::clamp(value_N, 0.0, fullScale_N);
                    const double beyond_N = value_N - within_N;
                    const double slope = beyond_N > 0.0 ? 1.0 - bend : 1.0 + bend;
                    value_N = within_N + bend * within_N * (1.0 - within_N / fullScale_N) + slope * beyond_N;
                }
            }};
}

} // namespace teleta::simulation
