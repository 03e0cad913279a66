// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/cubic_spline.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

namespace teleta::contour {

namespace {

// Inputs are rounded to half an ulp; the system amplifies this by at most 3, second differences by at most 4.
constexpr double kRoundingUlps = 32.0;

/// Solves the tridiagonal system with off-diagonals 1 and the given diagonal in place.
void solveTridiagonal(std::span<const double> diagonal, std::span<Point> rightSide) {
    const std::size_t n = diagonal.size();
    if (n == 0)
        return;
    std::vector<double> ratio(n);
    double pivot = diagonal[0];
    rightSide[0] /= pivot;
    for (std::size_t i = 1; i < n; ++i) {
        ratio[i - 1] = 1.0 / pivot;
        pivot = diagonal[i] - ratio[i - 1];
        rightSide[i] = (rightSide[i] - rightSide[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;)
        rightSide[i] -= ratio[i] * rightSide[i + 1];
}

/// Control points of the natural interpolating spline: the ends are the points themselves.
void solveNatural(std::span<Point> points) {
    const std::size_t n = points.size();
    if (n < 3)
        return;
    const auto inner = points.subspan(1, n - 2);
    for (Point& p : inner)
        p *= 6.0;
    inner.front() -= points.front();
    inner.back() -= points.back();
    solveTridiagonal(std::vector<double>(inner.size(), 4.0), inner);
}

/// Control points of the periodic interpolating spline (Sherman-Morrison on the two corner elements).
void solveCyclic(std::span<Point> points) {
    const std::size_t n = points.size();
    if (n < 2)
        return;
    if (n == 2) {
        const Point first = 2.0 * points[0] - points[1];
        points[1] = 2.0 * points[1] - points[0];
        points[0] = first;
        return;
    }
    constexpr double kGamma = -4.0;
    std::vector<double> diagonal(n, 4.0);
    diagonal.front() = 4.0 - kGamma;
    diagonal.back() = 4.0 - 1.0 / kGamma;
    for (Point& p : points)
        p *= 6.0;
    solveTridiagonal(diagonal, points);

    std::vector<Point> corner(n, Point::Zero());
    corner.front() = Point::Constant(kGamma);
    corner.back() = Point::Ones();
    solveTridiagonal(diagonal, corner);

    const Point factor =
        (points.front() + points.back() / kGamma) / (1.0 + corner.front().x() + corner.back().x() / kGamma);
    for (std::size_t i = 0; i < n; ++i)
        points[i] -= corner[i].x() * factor;
}

} // namespace

bool areUsable(std::span<const Point> points_m) {
    // islessequal is false for NaN and, unlike <=, raises no floating-point exception for it.
    return std::all_of(points_m.begin(), points_m.end(), [](const Point& p) {
        return std::islessequal(std::abs(p.x()), kMaximumCoordinate_m) &&
               std::islessequal(std::abs(p.y()), kMaximumCoordinate_m);
    });
}

std::optional<CubicSpline> CubicSpline::fit(std::span<const Point> points_m, SplineKind kind, bool closed) {
    if (points_m.empty() || !areUsable(points_m))
        return std::nullopt;

    const std::size_t n = points_m.size();
    CubicSpline spline;
    spline.m_origin_m = points_m.front();
    spline.m_closed = closed && n > 1;
    spline.m_segments = spline.m_closed ? n : n - 1;

    // One phantom before the points and one (open) or two (closed) after them.
    auto& control = spline.m_control_m;
    control.resize(n + (spline.m_closed ? 3 : 2));
    const std::span<Point> own(control.data() + 1, n);
    double largest_m = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        own[i] = points_m[i] - spline.m_origin_m;
        largest_m = std::max(largest_m, points_m[i].cwiseAbs().maxCoeff());
    }
    spline.m_rounding_m = kRoundingUlps * std::numeric_limits<double>::epsilon() * largest_m;

    if (kind == SplineKind::interpolating) {
        if (spline.m_closed)
            solveCyclic(own);
        else
            solveNatural(own);
    }
    if (spline.m_closed) {
        control.front() = own.back();
        control[n + 1] = own[0];
        control[n + 2] = own[1];
    } else if (n > 1) {
        control.front() = 2.0 * own[0] - own[1];
        control.back() = 2.0 * own[n - 1] - own[n - 2];
    }
    return spline;
}

CubicSpline::Place CubicSpline::locate(double t) const {
    const auto end = static_cast<double>(m_segments);
    if (m_segments == 0 || std::isnan(t))
        return {};
    if (m_closed && (t < 0.0 || t >= end)) {
        t = std::isinf(t) ? 0.0 : std::fmod(t, end);
        if (t < 0.0)
            t += end;
    }
    t = std::clamp(t, 0.0, end);
    const std::size_t segment = std::min(static_cast<std::size_t>(t), m_segments - 1);
    return {segment, t - static_cast<double>(segment)};
}

Point CubicSpline::position_m(double t) const {
    if (m_segments == 0)
        return m_origin_m;
    const auto [segment, u] = locate(t);
    const Point* c = &m_control_m[segment];
    const double v = 1.0 - u;
    const Point local = (v * v * v * c[0] + (4.0 - 6.0 * u * u + 3.0 * u * u * u) * c[1] +
                         (4.0 - 6.0 * v * v + 3.0 * v * v * v) * c[2] + u * u * u * c[3]) /
                        6.0;
    return m_origin_m + local;
}

Point CubicSpline::derivativeAt_m(Place place) const {
    const auto [segment, u] = place;
    const Point* c = &m_control_m[segment];
    const double v = 1.0 - u;
    return 0.5 * (v * v * (c[1] - c[0]) + (1.0 + 2.0 * u * v) * (c[2] - c[1]) + u * u * (c[3] - c[2]));
}

Point CubicSpline::secondDerivativeAt_m(Place place) const {
    const auto [segment, u] = place;
    const Point* c = &m_control_m[segment];
    return (1.0 - u) * ((c[2] - c[1]) - (c[1] - c[0])) + u * ((c[3] - c[2]) - (c[2] - c[1]));
}

Point CubicSpline::derivative_m(double t) const {
    return m_segments == 0 ? Point(Point::Zero()) : derivativeAt_m(locate(t));
}

Point CubicSpline::secondDerivative_m(double t) const {
    return m_segments == 0 ? Point(Point::Zero()) : secondDerivativeAt_m(locate(t));
}

double CubicSpline::curvature_perM(double t) const {
    if (m_segments == 0)
        return 0.0;
    const Place place = locate(t);
    const Point first = derivativeAt_m(place);
    const Point second = secondDerivativeAt_m(place);
    // With unit vectors the powers in (11) neither overflow nor underflow at any scale.
    const double speed = std::hypot(first.x(), first.y());
    const double change = std::hypot(second.x(), second.y());
    if (speed <= m_rounding_m || change <= m_rounding_m)
        return 0.0;
    const double sine = cross(first / speed, second / change);
    if (std::abs(sine) <= m_rounding_m / change + m_rounding_m / speed)
        return 0.0;
    return sine * (change / speed) / speed;
}

double CubicSpline::length_m() const {
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 15>;
    constexpr unsigned kDepth = 15; // each level divides the error at a cusp by four
    constexpr double kTolerance = 1e-10;
    double total_m = 0.0;
    for (std::size_t segment = 0; segment < m_segments; ++segment) {
        const auto speed = [&](double u) {
            const Point d = derivativeAt_m({segment, u});
            return std::hypot(d.x(), d.y());
        };
        total_m += Quadrature::integrate(speed, 0.0, 1.0, kDepth, kTolerance);
    }
    return total_m;
}

} // namespace teleta::contour
