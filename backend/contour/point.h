// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <span>

namespace teleta::contour {

/// A contact point in the plane of exploration, (x, y) in m.
using Point = Eigen::Vector2d;

/// Larger coordinates are refused like NaN, so that no squared distance overflows.
inline constexpr double kMaximumCoordinate_m = 1e150;

/// z component of the cross product of two vectors in the plane.
[[nodiscard]] inline double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether every coordinate is finite and at most kMaximumCoordinate_m in magnitude.
[[nodiscard]] bool areUsable(std::span<const Point> points_m);

} // namespace teleta::contour
