// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"

#include <optional>
#include <span>

namespace teleta::contact {

/// Where a round body presses deepest, at a resolution finer than the taxels, in the sensor frame {s}.
struct Summit {
    double x_m = 0.0;
    double y_m = 0.0;
    double peak_N = 0.0; ///< load that a taxel at that place would have
};

/// Finds the summit of the paraboloid through the loads of the active taxels:
///   load = a + b x + c y - d (x^2 + y^2),  least squares weighted by the loads,  summit (b, c) / 2d
/// On a bed of springs a ball has this profile, even where the border of the array cuts the contact off,
/// which would bias a centroid inwards. The frame must hold a single contact. Independent of the unit of
/// load. load_N: layout.taxels() values, >= 0 and finite; threshold_N: > 0, a taxel is active from it on.
/// Empty for fewer than five active taxels, when they lie on a line, when the loads do not fall off from a
/// summit, or when the summit is more than half a taxel outside the active ones. Thread: any (pure);
/// allocates nothing.
[[nodiscard]] std::optional<Summit> summitOf(std::span<const float> load_N, const core::ArrayLayout& layout,
                                             float threshold_N);

} // namespace teleta::contact
