// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <span>

namespace teleta::contour {

/// A contact point in the plane of exploration, (x, y) in m.
using Point = Eigen::Vector2d;

/// Coordinates beyond this are refused like NaN, so that no square of a distance overflows.
inline constexpr double kMaximumCoordinate_m = 1e150;

/// Whether every coordinate is finite and within the valid range.
/// z component of the cross product of two vectors in the plane.
[[nodiscard]] inline double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}

[[nodiscard]] bool areUsable(std::span<const Point> points_m);

} // namespace teleta::contour
