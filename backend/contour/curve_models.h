// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"
#include "backend/contour/robust_fit.h"

#include <optional>
#include <vector>

namespace teleta::contour {

/// A circle, or a straight line as its limit, in a form that is regular at zero curvature:
///   A z + B x + C y + D = 0,  z = x^2 + y^2,  B = E cos(theta),  C = E sin(theta),  E = sqrt(1 + 4 A D)
/// with x, y from a point near the curve, so that D is small and E near 1. The distance of a point is
///   d = 2 P / (1 + sqrt(1 + 4 A P)),  P = A z + B x + C y + D
/// which has no cancellation for any radius 1/(2|A|). Source: Chernov, Circular and linear regression,
/// chapters 3 and 5 (Pratt's normalisation).
struct CurvedLine {
    Point reference = Point::Zero();
    double a = 0.0;
    double d = 0.0;
    double theta_rad = 0.0;

    [[nodiscard]] bool straight() const { return std::abs(a) < 1e-9; }
    [[nodiscard]] double radius() const { return 0.5 / std::abs(a); } ///< not straight()
    [[nodiscard]] Point centre() const;                               ///< not straight()
    [[nodiscard]] Point foot(const Point& p) const;                   ///< of a straight one
};

/// A fitted model and the curve that it describes.
struct CurvedLineFit {
    RobustFit fit; ///< parameters (A, D, theta), or (D, theta) of a straight line
    CurvedLine curve;
};

/// Robust geometric fits. points: in units of their size, at least 2 (line) or 3 (circle). The circle is
/// started from Taubin's algebraic fit, from circles through triples of points and from the line; the best
/// start is refined. Thread: any (pure).
[[nodiscard]] CurvedLineFit fitLine(std::span<const Point> points);
[[nodiscard]] CurvedLineFit fitCurvedLine(std::span<const Point> points);

/// Taubin's algebraic circle fit as (centre x, centre y, radius); empty when the points are on a line.
[[nodiscard]] std::optional<Eigen::Vector3d> taubinCircle(std::span<const Point> points);

/// Fits an ellipse; parameters: centre x, centre y, log a, log b, angle. Started from the scatter matrix and
/// from a circle. Distances are of first order; exact for a circle.
[[nodiscard]] RobustFit fitEllipse(std::span<const Point> points, const CurvedLine& circle);
[[nodiscard]] double ellipseLength(const Eigen::VectorXd& parameters);
/// For each point the place of the nearest point of the ellipse, about: 0 .. ellipseLength().
[[nodiscard]] std::vector<double> placesOnEllipse(std::span<const Point> points,
                                                  const Eigen::VectorXd& parameters);

} // namespace teleta::contour
