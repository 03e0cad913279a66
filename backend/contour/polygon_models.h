// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/model_evidence.h"
#include "backend/contour/point.h"

#include <vector>

namespace teleta::contour {

/// A closed polygon with fewer parameters than vertices, fitted robustly.
struct PolygonFit {
    RobustFit fit;
    Eigen::VectorXd vertices; ///< coordinates, counter-clockwise
    /// Of a regular polygon: evidence, with the whole perimeter as length.
    Evidence judged{.logEvidence = kImpossibleEvidence};
};

/// Fits a rectangle; parameters: centre x, centre y, angle, half width, half height. points: in units of
/// their size, at least one. Started from boxes around the points at several angles and from boxes near the
/// given quadrilaterals. Thread: any (pure).
[[nodiscard]] PolygonFit fitRectangle(std::span<const Point> points,
                                      const std::vector<Eigen::VectorXd>& quadrilaterals);

/// Fits a regular polygon, started near a circle; parameters: centre x, centre y, log of the circumradius,
/// angle.
[[nodiscard]] PolygonFit fitRegularPolygon(std::span<const Point> points, int sides, const Point& centre,
                                           double radius);

/// First guess of a triangle: the coordinates of one of large area whose vertices are among the points (at
/// least one).
[[nodiscard]] Eigen::VectorXd largeTriangle(std::span<const Point> points);

/// How a curve was explored.
struct Explored {
    double length = 0.0;        ///< of the part that was touched
    double period = 0.0;        ///< perimeter; 0 for an open curve
    double untouched = 0.0;     ///< share of the perimeter, see untouchedShare()
    bool everyEdge = true;      ///< every edge has a point that is not near its ends
    std::vector<double> places; ///< of all points along the curve
};
[[nodiscard]] Explored explored(std::span<const Point> points, const Evidence& judged,
                                const Eigen::VectorXd& vertices);

/// Share of a closed curve that was left out: its widest gap minus the second widest, divided by the period.
/// Points at random places leave about 1 / number of them, evenly spaced ones nothing. 0 for fewer than two
/// positions. positions: 0 <= s < period.
[[nodiscard]] double untouchedShare(std::vector<double> positions, double period);

} // namespace teleta::contour
