// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/border_stiffening.h"

#include <cstddef>

namespace teleta::simulation {

std::vector<double> borderStiffness(const scene::BorderStiffeningSpec& spec,
                                    const core::ArrayLayout& layout) {
    std::vector<double> factors(layout.taxels(), 1.0);
    for (int row = 0; row < layout.rows; ++row) {
        for (int column = 0; column < layout.columns; ++column) {
            const int borders = (row == 0 || row == layout.rows - 1 ? 1 : 0) +
                                (column == 0 || column == layout.columns - 1 ? 1 : 0);
            factors[static_cast<std::size_t>(row) * layout.columns + column] += borders * spec.share;
        }
    }
    return factors;
}

} // namespace teleta::simulation
