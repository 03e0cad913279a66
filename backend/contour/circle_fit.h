// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"

#include <optional>

namespace teleta::contour {

struct Circle {
    Point centre_m = Point::Zero();
    double radius_m = 0.0;
    double rms_m = 0.0; ///< root mean square distance of the points from the circle, without outliers
};

/// Fits a circle by robust least squares of the distances (Taubin's algebraic fit, then geometric refinement;
/// see CurvedLine). The points may cover any part of the circle and contain outliers. Empty for fewer than
/// three points, points on a line or in one place, and unusable coordinates (areUsable()). Thread: any
/// (pure).
[[nodiscard]] std::optional<Circle> fitCircle(std::span<const Point> points_m);

} // namespace teleta::contour
