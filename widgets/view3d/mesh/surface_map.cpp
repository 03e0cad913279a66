// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/surface_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

CylinderSize cylinderThatFits(const CylinderSize& wanted, const core::ArrayLayout& layout) {
    const double round_m = layout.rows * layout.pitchY_m;
    return {.radius_m = std::max(wanted.radius_m, round_m / (2.0 * std::numbers::pi)),
            .length_m = std::max(wanted.length_m, layout.columns * layout.pitchX_m)};
}

Eigen::Vector3d SurfaceMap::point(double x_m, double y_m, double height_m) const {
    if (m_surface == Surface::plate)
        return {x_m, y_m, height_m};
    const double angle = y_m / m_radius_m;
    const double r_m = m_radius_m + height_m;
    return {x_m, r_m * std::sin(angle), r_m * std::cos(angle)};
}

Eigen::Vector3d SurfaceMap::normal(double y_m) const {
    if (m_surface == Surface::plate)
        return Eigen::Vector3d::UnitZ();
    const double angle = y_m / m_radius_m;
    return {0.0, std::sin(angle), std::cos(angle)};
}

} // namespace teleta::view3d
