// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <initializer_list>

namespace teleta::figure {

/// The smallest step of an axis that is at least so large: 1, 2 or 5 times a power of ten. atLeast: > 0,
/// finite. Thread: any (pure).
[[nodiscard]] inline double roundStep(double atLeast) {
    const double power = std::pow(10.0, std::floor(std::log10(atLeast)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= atLeast * (1.0 - 1e-9))
            return factor * power;
    }
    return 10.0 * power;
}

} // namespace teleta::figure
