// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"

#include <optional>
#include <span>

namespace teleta::contact {

/// Where a round body presses deepest, finer than the taxels, in the sensor frame.
struct Summit {
    double x_m = 0.0;
    double y_m = 0.0;
    double peak_N = 0.0; ///< load that a taxel there would have
};

/// Summit of the paraboloid through the loads of the active taxels:
///   load = a + b x + c y - d (x^2 + y^2),  least squares weighted by the loads,  summit (b, c) / 2d
/// On a foundation of springs that is the profile of a ball, also where the border of the array cuts its
/// contact off, which pulls a centroid inward. One contact in the frame: of several it is none. Scale-free.
/// load_N: layout.taxels() values, >= 0 and finite; threshold_N: > 0, a taxel is active from it on. Empty for
/// fewer than five active taxels, when they lie in a line, when the loads do not fall from a summit, or when
/// it is more than half a taxel beyond the active ones. Thread: any (pure); nothing is allocated.
[[nodiscard]] std::optional<Summit> summitOf(std::span<const float> load_N, const core::ArrayLayout& layout,
                                             float threshold_N);

} // namespace teleta::contact
