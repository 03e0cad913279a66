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

    /// The shapes that come into question, the most probable one first: the fewest that together have a
    /// probability of at least kDecided. Only one: the points decide.
    [[nodiscard]] std::vector<Shape> candidates() const;
    static constexpr double kDecided = 0.9;
};

/// Recognises the shape of a series of contact points in the order in which they were touched.
///
/// Each named shape, and for `unknown` a set of others (parts of a triangle or rectangle, ellipse, chains and
/// polygons with any number of edges, curves that follow a named shape only roughly, a random walk, scatter),
/// is fitted by robust least squares of the distances and weighed (shape_models.h, shape_prior.h). The shape
/// is the most probable one. Its confidence is the share of such answers that are right, within a few
/// percent, where two thirds of the contours have a named shape, and have 4 to 60 points with noise of 0 to 6
/// % of the size. With few points it is low, and candidates() names what comes into question. In addition:
///   circle or arc: decided by the part that was left out, about an eighth or more of an arc; triangle or
///   rectangle: `unknown` when only a part of it was touched; a square is a rectangle; point: the extent is
///   under the resolution; then the confidence is 1/(1 + (extent/resolution)^8).
/// Defined for any number of points: none give unknown with confidence 0, points all in one place a point,
/// and two different points a line with confidence 0.5, because two points are always on a line. Points
/// further away than three sizes of the contour are left out. More than 360 points are thinned evenly. Empty
/// when a coordinate is unusable. Thread: any (pure); takes a fifth of a millisecond for 30 points. Source:
/// TeleTA, section 3.
[[nodiscard]] std::optional<Recognition> recogniseShape(std::span<const Point> points_m,
                                                        const RecognitionSettings& settings = {});

} // namespace teleta::contour
