// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace teleta::contour {

using Points = std::vector<Point>;

inline Point onCircle(double radius_m, double angle_rad) {
    return {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)};
}

/// count points at equal angles, beginning on the x axis, counter-clockwise.
inline Points circlePoints(std::size_t count, double radius_m = 1.0) {
    Points points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(
            onCircle(radius_m, 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count)));
    return points;
}

inline Point rotated(const Point& p, double angle_rad) {
    return {p.x() * std::cos(angle_rad) - p.y() * std::sin(angle_rad),
            p.x() * std::sin(angle_rad) + p.y() * std::cos(angle_rad)};
}

/// scale, then rotation, then shift.
inline Points moved(Points points, double scale, double angle_rad, const Point& shift_m) {
    for (Point& p : points)
        p = rotated(scale * p, angle_rad) + shift_m;
    return points;
}

} // namespace teleta::contour
