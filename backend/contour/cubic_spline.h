// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace teleta::contour {

enum class SplineKind {
    approximating, ///< the points are the control points, as in the paper; smooths, and cuts corners
    interpolating, ///< the curve passes through every point
};

/// Cubic uniform B-spline of a series of contact points.
///   P_i(t) = 1/6 [t^3 t^2 t 1] M [c_{i-1} c_i c_{i+1} c_{i+2}]^T                                     (7)
/// The parameter t runs from 0 to segments(), one unit a segment; at integer t the curve passes through
/// (interpolating) or near (approximating) the point of that index. A closed curve has a segment between the
/// last point and the first and is periodic in t. An open curve has phantom control points c_{-1} = 2 c_0 -
/// c_1 (and likewise at the end), so that both kinds begin at the first point and end at the last with zero
/// curvature; between t = 1 and segments() - 1 the approximating curve is the paper's. Interpolation solves
/// the natural or cyclic tridiagonal system (1 4 1) c = 6 p in O(n); its condition number is at most 3 for
/// any points. Twice continuously differentiable in t. Points may repeat. One point gives a curve without
/// segments that stays there. Thread: any (immutable). Source: TeleTA, eq. (7)-(11).
class CubicSpline {
public:
    /// Empty when there are no points, or a coordinate is not finite or beyond kMaximumCoordinate_m.
    [[nodiscard]] static std::optional<CubicSpline> fit(std::span<const Point> points_m, SplineKind kind,
                                                        bool closed);

    [[nodiscard]] std::size_t segments() const { return m_segments; }
    [[nodiscard]] bool closed() const { return m_closed; }

    /// t outside the range wraps around (closed) or is clamped (open); NaN counts as 0.
    [[nodiscard]] Point position_m(double t) const;
    [[nodiscard]] Point derivative_m(double t) const;       ///< dP/dt
    [[nodiscard]] Point secondDerivative_m(double t) const; ///< d2P/dt2

    /// Signed curvature, positive where the curve turns counter-clockwise.
    ///   kappa = (x' y'' - y' x'') / (x'^2 + y'^2)^{3/2}                                               (11)
    /// 0 where the derivative vanishes (at a cusp or repeated points, where no direction is defined) and
    /// where the numerator is within the rounding error of points on a line.
    [[nodiscard]] double curvature_perM(double t) const;

    /// Length of the whole curve by adaptive Gauss-Kronrod quadrature of |dP/dt|; relative error below 1e-9.
    [[nodiscard]] double length_m() const;

private:
    struct Place {
        std::size_t segment = 0;
        double u = 0.0; ///< 0..1 within the segment
    };
    CubicSpline() = default;
    [[nodiscard]] Place locate(double t) const;
    [[nodiscard]] Point derivativeAt_m(Place place) const;
    [[nodiscard]] Point secondDerivativeAt_m(Place place) const;

    Point m_origin_m = Point::Zero();
    std::vector<Point> m_control_m; ///< relative to the origin; segment i uses i .. i + 3
    std::size_t m_segments = 0;
    bool m_closed = false;
    double m_rounding_m = 0.0; ///< bound on the rounding error of a coordinate of a derivative
};

} // namespace teleta::contour
