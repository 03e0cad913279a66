// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/circle_fit.h"
#include "backend/contour/point.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::contour {

/// The first six are the shape patterns A..F of the bracelet, in this order.
enum class Shape { circle, rectangle, triangle, arc, line, point, unknown };
inline constexpr std::size_t kShapes = 7;

/// Name in files and on the command line: "circle", "rectangle", ..., "unknown".
[[nodiscard]] const char* toString(Shape shape);

struct RecognitionSettings {
    double resolution_m = 0.0034; ///< a contour smaller than this is a point; >= 0
    std::optional<bool> closed;   ///< whether the contour is closed; empty: detect it
};

/// What a series of contact points looks like.
struct Recognition {
    Shape shape = Shape::unknown;
    double confidence = 0.0; ///< probability of the shape, 0..1
    std::array<double, kShapes>
        probability{};   ///< of each shape, indexed by Shape; sums to 1 unless there are no points
    bool closed = false; ///< the curve through the points returns to its start
    /// Corners of a rectangle or triangle, ends of a line, vertices of an unknown contour (findPolygon());
    /// otherwise empty.
    std::vector<Point> vertices_m;
    std::optional<Circle> circle; ///< of a circle or an arc
    double rms_m = 0.0;       ///< root mean square distance of the points from the shape, without outliers
    std::size_t outliers = 0; ///< number of points that do not belong to the shape
};

/// Recognises the shape of a series of contact points in the order in which they were touched.
///
/// Each named shape, and for `unknown` a set of others (ellipse, chains and polygons with any number of
/// edges, scatter), is fitted by robust least squares of the distances. The probability of a shape is its
/// evidence (model_evidence.h) divided by the sum over all, so the confidence is that of a decision between
/// these models: of the answers given with confidence 0.9, nine in ten are right for contours like those of
/// the calibration test. In addition:
///   circle or arc: decided by the covered angle; a circle has no gap wider than its usual spacing plus 45
///   degrees; rectangle, triangle: every edge was touched and no gap is wider than the usual spacing plus a
///   quarter of the perimeter; a square is a rectangle; point: the extent is under the resolution; then the
///   confidence is 1/(1 + (extent/resolution)^8).
/// Defined for any number of points: none give unknown with confidence 0, points all in one place a point,
/// and two different points a line with confidence 0.5, because two points are always on a line. A model
/// needs more points than parameters. Points further away than three sizes of the contour are left out. More
/// than 360 points are thinned evenly. Empty when a coordinate is unusable. Thread: any (pure); takes a few
/// milliseconds for 60 points. Source: TeleTA, section 3.
[[nodiscard]] std::optional<Recognition> recogniseShape(std::span<const Point> points_m,
                                                        const RecognitionSettings& settings = {});

} // namespace teleta::contour
