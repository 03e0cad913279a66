// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace teleta::scene {

[[nodiscard]] inline bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

[[nodiscard]] inline bool isNotNegative(double value) {
    return std::isfinite(value) && value >= 0.0;
}

} // namespace teleta::scene
