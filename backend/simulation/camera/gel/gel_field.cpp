// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/gel/gel_field.h"

#include <cmath>
#include <numbers>

namespace teleta::simulation {

namespace {

/// x: distance over the radius of the load.
double draggedAlong(double x) {
    if (x <= 1.0)
        return 1.0 - 0.5 * x * x;
    return ((2.0 - x * x) * std::asin(1.0 / x) + std::sqrt(x * x - 1.0)) / std::numbers::pi;
}

} // namespace

Eigen::Vector2d GelContact::displacement_m(const Eigen::Vector2d& place_m) const {
    const Eigen::Vector2d from_m = place_m - centre_m;
    const double x = from_m.norm() / radius_m;
    Eigen::Vector2d moved_m = spread_m / radius_m * std::exp(0.5 * (1.0 - x * x)) * from_m;
    double shear = draggedAlong(x);
    if (stick > 0.0)
        shear -= stick * stick * draggedAlong(x / stick);
    moved_m += shear * slip_m;
    const double turned_rad = x <= 1.0 ? turn_rad : turn_rad / (x * x * x);
    const double cosine = std::cos(turned_rad);
    const double sine = std::sin(turned_rad);
    moved_m += Eigen::Vector2d((cosine - 1.0) * from_m.x() - sine * from_m.y(),
                               sine * from_m.x() + (cosine - 1.0) * from_m.y());
    return moved_m;
}

} // namespace teleta::simulation
