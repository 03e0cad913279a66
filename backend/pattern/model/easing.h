// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/parametric_object.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::pattern {

/// Share of the change between two breakpoints that is completed at u (0 to 1); see Easing. Thread: any
/// (pure).
[[nodiscard]] inline double eased(Easing easing, double u) {
    switch (easing) {
    case Easing::linear:
        break;
    case Easing::hold:
        return 0.0;
    case Easing::easeIn:
        return 1.0 - std::cos(0.5 * std::numbers::pi * u);
    case Easing::easeOut:
        return std::sin(0.5 * std::numbers::pi * u);
    case Easing::easeInOut:
        return 0.5 * (1.0 - std::cos(std::numbers::pi * u));
    }
    return u;
}

/// Clamps an intensity to 0..1; NaN becomes 0.
[[nodiscard]] inline double limitedIntensity(double intensity) {
    return intensity > 0.0 ? std::min(intensity, 1.0) : 0.0;
}

} // namespace teleta::pattern
