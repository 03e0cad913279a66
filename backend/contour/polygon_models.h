// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/model_evidence.h"
#include "backend/contour/point.h"

#include <vector>

namespace teleta::contour {

/// A closed polygon with fewer parameters than vertices, fitted robustly.
struct PolygonFit {
    RobustFit fit;
    Evidence judged;          ///< with the whole perimeter as length
    Eigen::VectorXd vertices; ///< coordinates, counter-clockwise
};

/// Rectangle (centre x, centre y, angle, half width, half height) of points in units of their size, at least
/// one. Starts: boxes around the points at several angles, and boxes near the given quadrilaterals.
[[nodiscard]] PolygonFit fitRectangle(std::span<const Point> points,
                                      const std::vector<Eigen::VectorXd>& quadrilaterals);

/// Regular polygon (centre x, centre y, log of the circumradius, angle), started near a circle.
[[nodiscard]] PolygonFit fitRegularPolygon(std::span<const Point> points, int sides, const Point& centre,
                                           double radius);

/// Coordinates of a triangle of large area with its vertices among the points (at least one), as a first
/// guess.
[[nodiscard]] Eigen::VectorXd largeTriangle(std::span<const Point> points);

/// How a closed chain was explored.
struct Explored {
    double length = 0.0;    ///< perimeter without the part of the widest gap that is beyond the usual spacing
    double period = 0.0;    ///< perimeter; 0 of an open curve
    double gap = 0.0;       ///< widest gap less the usual spacing
    bool everyEdge = false; ///< every edge has a point that is not near its ends
    std::vector<double> places; ///< of all points along the chain
};
[[nodiscard]] Explored explored(std::span<const Point> points, const Evidence& judged,
                                const Eigen::VectorXd& vertices);

/// Widest gap between positions 0 <= s < period around a closed curve, less the mean of the other gaps.
[[nodiscard]] double gapBeyondSpacing(std::vector<double> positions, double period);

} // namespace teleta::contour
