// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace teleta::simulation {

/// How the surface of a flat gel moves along itself under one ball, as closed forms:
///   press   radially by  s (r / a) exp((1 - r^2 / a^2) / 2),  s: spread at the rim
///   shear   U (h(r / a) - (c / a)^2 h(r / c)): the ball's ring of slip (Cattaneo, Mindlin). What lies within
///           c moves by U (1 - (c / a)^2) as one; U: the way at which all slips; c = a (1 - Q / (mu P))^(1/3)
///           h(x) = 1 - x^2 / 2 within 1, else ((2 - x^2) asin(1 / x) + x sqrt(1 - 1 / x^2)) / pi
///   twist   turn within a, which falls as (a / r)^3 outside: what a rigid ball that sticks drags along
/// Source: K. L. Johnson, Contact Mechanics (1985), 7.2, with Poisson's number 0, for which the shear is the
/// same in all directions. Lengths in m on the gel's surface. Thread: any (pure).
struct GelContact {
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    double radius_m = 0.002; ///< a, of the contact; > 0
    double spread_m = 0.0;
    Eigen::Vector2d slip_m = Eigen::Vector2d::Zero(); ///< U, with its direction
    double stick = 1.0;                               ///< c / a, 0..1
    double turn_rad = 0.0;

    [[nodiscard]] Eigen::Vector2d displacement_m(const Eigen::Vector2d& place_m) const;
};

} // namespace teleta::simulation
