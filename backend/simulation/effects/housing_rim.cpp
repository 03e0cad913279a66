// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/housing_rim.h"

#include <cmath>

namespace teleta::simulation {

namespace {

constexpr double kSpringsPerPitch = 5.0;

} // namespace

std::vector<RimSide> housingRim(const scene::HousingRimSpec& spec, const core::ArrayLayout& layout) {
    const double halfX_m = 0.5 * layout.columns * layout.pitchX_m;
    const double halfY_m = 0.5 * layout.rows * layout.pitchY_m;
    const double middleX_m = 0.5 * (halfX_m + 0.5 * spec.length_m);
    const double middleY_m = 0.5 * (halfY_m + 0.5 * spec.width_m);
    std::vector<RimSide> sides;
    const auto add = [&](const Eigen::Vector3d& middle_m, const Eigen::Vector3d& along, double half_m) {
        const auto count = static_cast<int>(std::ceil(2.0 * half_m / layout.pitchX_m * kSpringsPerPitch));
        const double step_m = 2.0 * half_m / count;
        sides.push_back({.first_m = middle_m + (0.5 * step_m - half_m) * along,
                         .step_m = step_m * along,
                         .count = count,
                         .stiffness_NPerM = spec.stiffness_NPerM * step_m / layout.pitchX_m});
    };
    for (const double sign : {-1.0, 1.0}) {
        if (middleX_m > halfX_m)
            add({sign * middleX_m, 0.0, -spec.recess_m}, Eigen::Vector3d::UnitY(), 0.5 * spec.width_m);
        if (middleY_m > halfY_m)
            add({0.0, sign * middleY_m, -spec.recess_m}, Eigen::Vector3d::UnitX(), halfX_m);
    }
    return sides;
}

} // namespace teleta::simulation
