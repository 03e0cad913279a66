// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"

#include <optional>
#include <vector>

namespace teleta::contour {

/// A contour made ready for recognition: at most kMaximumPoints of its points in the order of exploration,
/// moved to their centre and divided by their size, without those that are grossly wrong.
struct PreparedContour {
    static constexpr std::size_t kMaximumPoints = 360;

    std::vector<Point> points; ///< in units of size_m about centre_m
    Point centre_m = Point::Zero();
    double size_m = 0.0;      ///< robust size: largest distance, leaving out a twentieth of the points
    double extent_m = 0.0;    ///< largest distance between two of the points; 0 when they are all one
    std::size_t rejected = 0; ///< points further away than three sizes, left out

    [[nodiscard]] Point toMetres(const Point& p) const { return centre_m + size_m * p; }
};

/// points_m: usable (areUsable). Of more than kMaximumPoints, evenly many are skipped.
[[nodiscard]] PreparedContour prepare(std::span<const Point> points_m);

/// Point with the least sum of distances; hardly moved by outliers.
[[nodiscard]] Point spatialMedian(std::span<const Point> points);

/// The points by their angle around their spatial median: the order of one counter-clockwise turn around a
/// convex shape, however it was explored.
[[nodiscard]] std::vector<Point> orderedByAngle(std::span<const Point> points);

/// The points of a contour that goes on beyond its start (overlaps, is traversed several times) merged into
/// one lap; otherwise the points unchanged.
[[nodiscard]] std::vector<Point> mergedLaps(std::span<const Point> points);

/// Leaves out points that are further from both neighbours than three usual steps while these are near each
/// other.
[[nodiscard]] std::vector<Point> withoutSpikes(std::span<const Point> points, bool closed);

/// Whether the last point of a contour comes back to the first: the gap between them is at most 1.75 usual
/// (median) steps and three quarters of the size. Needs four points. points: in units of their size.
[[nodiscard]] bool returnsToItsStart(std::span<const Point> points);

} // namespace teleta::contour
