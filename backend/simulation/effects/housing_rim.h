// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/scene/scene.h"

#include <Eigen/Core>

#include <vector>

namespace teleta::simulation {

/// Springs in a row along one side of the housing, in {s}.
struct RimSide {
    Eigen::Vector3d first_m;
    Eigen::Vector3d step_m; ///< from one to the next
    int count;
    double stiffness_NPerM; ///< of one
};

/// The rim of the housing around the sensitive area, a little below its surface: what presses on it is
/// carried and not sensed. Springs in the middle line of the rim, five a pitch or more; a piece as long as a
/// pitch has the stiffness of the spec. Sides where the housing is not larger than the array are left out.
[[nodiscard]] std::vector<RimSide> housingRim(const scene::HousingRimSpec& spec,
                                              const core::ArrayLayout& layout);

} // namespace teleta::simulation
