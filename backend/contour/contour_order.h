// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"

#include <optional>
#include <vector>

namespace teleta::contour {

/// A contour prepared for recognition: at most kMaximumPoints points in the order of exploration, relative to
/// their centre and divided by their size, without gross outliers.
struct PreparedContour {
    static constexpr std::size_t kMaximumPoints = 360;

    std::vector<Point> points; ///< in units of size_m about centre_m
    Point centre_m = Point::Zero();
    double size_m =
        0.0; ///< robust size: largest distance between two points after leaving out a twentieth of them
    double extent_m = 0.0;    ///< largest distance between two of the points; 0 when all are in one place
    std::size_t rejected = 0; ///< number of points left out, further away than three sizes

    [[nodiscard]] Point toMetres(const Point& p) const { return centre_m + size_m * p; }
};

/// Prepares a contour. points_m: usable (areUsable()); more than kMaximumPoints are thinned evenly. Thread:
/// any (pure).
[[nodiscard]] PreparedContour prepare(std::span<const Point> points_m);

/// The point with the least sum of distances to all points; robust against outliers.
[[nodiscard]] Point spatialMedian(std::span<const Point> points);

/// Sorts the points by their angle about their spatial median. This is the order of one counter-clockwise lap
/// around a convex shape, however it was explored.
[[nodiscard]] std::vector<Point> orderedByAngle(std::span<const Point> points);

/// Whether two closed contours have the same points in the same cyclic order, in either direction.
[[nodiscard]] bool isSameLap(std::span<const Point> a, std::span<const Point> b);

/// Merges a contour that continues beyond its start (overlap, several laps) into one lap; returns any other
/// contour unchanged.
[[nodiscard]] std::vector<Point> mergedLaps(std::span<const Point> points);

/// Removes points that are further than three median steps from both neighbours while these are near each
/// other.
[[nodiscard]] std::vector<Point> withoutSpikes(std::span<const Point> points, bool closed);

/// Whether a contour returns to its start: the gap between its last and first point is at most 1.75 median
/// steps and at most three quarters of the size. Needs four points. points: in units of their size.
[[nodiscard]] bool returnsToItsStart(std::span<const Point> points);

} // namespace teleta::contour
