// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <array>

namespace teleta::pattern {

/// Difference of two patterns on one tactor, in intensity.
struct TactorDifference {
    double largest = 0.0; ///< largest |a - b|, with both sides of steps
    double largestAt_s = 0.0;
    double rms = 0.0; ///< sqrt(1/T integral (a - b)^2 dt) over the longer pattern
};

struct Comparison {
    std::array<TactorDifference, core::kTactors> tactors;
    int largestTactor = 0;   ///< the tactor with the largest difference
    double rms = 0.0;        ///< over all tactors
    double duration_s = 0.0; ///< of the longer pattern; the other one is off after its end
};

/// Compares the intensities of two patterns. Exact for straight lines and holds (closed form on each piece),
/// within kBakeTolerance for eased segments and objects. Two patterns of zero duration do not differ. Error:
/// as linearised(). Thread: any (pure).
[[nodiscard]] core::Expected<Comparison> compared(const Pattern& a, const Pattern& b);

} // namespace teleta::pattern
