// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"

#include <optional>

namespace teleta::contour {

struct Circle {
    Point centre_m = Point::Zero();
    double radius_m = 0.0;
    double rms_m = 0.0; ///< distance of the points from the circle, outliers left out
};

/// Circle with the least robust sum of squared distances from the points (Taubin's algebraic fit, then
/// geometric refinement; see CurvedLine). Points may cover any part of it and contain outliers. Empty with
/// fewer than three points, points on a line or in one place, and unusable coordinates. Thread: any (pure).
[[nodiscard]] std::optional<Circle> fitCircle(std::span<const Point> points_m);

} // namespace teleta::contour
