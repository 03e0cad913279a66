// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/hole_grid.h"

#include <cmath>
#include <numbers>

namespace teleta::vision {

double HoleGrid::angle_rad(std::size_t hole) const {
    const int inRing = static_cast<int>(hole) % around;
    return firstAngle_rad + 2.0 * std::numbers::pi * inRing / around;
}

double HoleGrid::z_m(std::size_t hole) const {
    const double share = along > 1 ? static_cast<double>(ring(hole)) / (along - 1) : 0.0;
    return first_z_m + share * (last_z_m - first_z_m);
}

std::vector<Eigen::Vector3d> holesOnSkin_m(const HoleGrid& grid, const CylinderSurface& skin) {
    std::vector<Eigen::Vector3d> holes;
    holes.reserve(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const double angle_rad = grid.angle_rad(i);
        holes.emplace_back(skin.radius_m * std::cos(angle_rad), skin.radius_m * std::sin(angle_rad),
                           grid.z_m(i));
    }
    return holes;
}

} // namespace teleta::vision
