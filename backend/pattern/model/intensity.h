// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace teleta::pattern {

/// Clamps an intensity to 0..1; NaN becomes 0.
[[nodiscard]] inline double limitedIntensity(double intensity) {
    return intensity > 0.0 ? std::min(intensity, 1.0) : 0.0;
}

} // namespace teleta::pattern
