// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/shape_recogniser.h"

#include "backend/contour/contour_order.h"
#include "backend/contour/shape_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::contour {

namespace {

constexpr double kPointSharpness = 8.0;
constexpr double kConfidenceOfTwoPoints = 0.5;

std::size_t index(Shape shape) {
    return static_cast<std::size_t>(shape);
}

/// Probability that a contour of this extent is a point.
double pointProbability(double extent_m, double resolution_m) {
    if (extent_m == 0.0)
        return 1.0;
    if (!(resolution_m > 0.0))
        return 0.0;
    const double ratio = std::min(extent_m / resolution_m, 1e6);
    return 1.0 / (1.0 + std::pow(ratio, kPointSharpness));
}

} // namespace

const char* toString(Shape shape) {
    static constexpr const char* kNames[kShapes] = {"circle", "rectangle", "triangle", "arc",
                                                    "line",   "point",     "unknown"};
    return kNames[index(shape)];
}

std::optional<Recognition> recogniseShape(std::span<const Point> points_m,
                                          const RecognitionSettings& settings) {
    if (!areUsable(points_m))
        return std::nullopt;
    Recognition result;
    result.closed = settings.closed.value_or(false);
    if (points_m.empty())
        return result;

    const PreparedContour contour = prepare(points_m);
    result.outliers = contour.rejected;
    const double point = pointProbability(contour.extent_m, settings.resolution_m);
    result.probability[index(Shape::point)] = point;
    const auto decide = [&](Shape shape) {
        result.shape = shape;
        result.confidence = result.probability[index(shape)];
    };
    if (contour.extent_m == 0.0 || contour.extent_m < settings.resolution_m) {
        result.probability[index(Shape::unknown)] = 1.0 - point;
        decide(Shape::point);
        return result;
    }
    if (contour.points.size() == 2) {
        result.probability[index(Shape::line)] = kConfidenceOfTwoPoints * (1.0 - point);
        result.probability[index(Shape::unknown)] = (1.0 - kConfidenceOfTwoPoints) * (1.0 - point);
        decide(Shape::line);
        for (const Point& p : contour.points)
            result.vertices_m.push_back(contour.toMetres(p));
        return result;
    }

    const ShapeCandidates candidates = explain(contour, settings.closed);
    std::array<double, kShapes> logWeights;
    logWeights.fill(-std::numeric_limits<double>::infinity());
    double total = -std::numeric_limits<double>::infinity();
    for (const ShapeCandidate& c : candidates.all) {
        logWeights[index(c.shape)] = logSum(logWeights[index(c.shape)], c.logWeight);
        total = logSum(total, c.logWeight);
    }
    for (std::size_t i = 0; i < kShapes; ++i)
        result.probability[i] += (1.0 - point) * std::exp(logWeights[i] - total);
    decide(static_cast<Shape>(std::max_element(logWeights.begin(), logWeights.end()) - logWeights.begin()));

    const ShapeCandidate* best = nullptr;
    for (const ShapeCandidate& c : candidates.all)
        if (c.shape == result.shape && (best == nullptr || c.logWeight > best->logWeight))
            best = &c;
    result.outliers += best->judged.outlierCount();
    result.rms_m = contour.size_m * rmsOfInliers(best->fit, best->judged);
    for (const Point& p : best->vertices)
        result.vertices_m.push_back(contour.toMetres(p));
    if (best->circle)
        result.circle = Circle{contour.toMetres(best->circle->centre()),
                               contour.size_m * best->circle->radius(), result.rms_m};
    if (!settings.closed) {
        const bool named = result.shape != Shape::unknown;
        const bool ends = result.shape == Shape::arc || result.shape == Shape::line;
        result.closed = named ? !ends : candidates.closed;
    }
    return result;
}

} // namespace teleta::contour
