// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/shape_recogniser.h"

#include "backend/contour/shape_prior.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace teleta::contour {

namespace {

constexpr double kPointSharpness = 8.0;
constexpr double kConfidenceOfTwoPoints = 0.5;
constexpr double kSurprise = 0.004; ///< share of contours that no model foresees
/// Of the shapes, without looking; a point is told by its extent alone.
constexpr std::array<double, kShapes> kPrior = {0.15, 0.17, 0.15, 0.14, 0.11, 0.0, 0.28};

std::size_t index(Shape shape) {
    return static_cast<std::size_t>(shape);
}

Shape shapeOf(Model model) {
    switch (model) {
    case Model::circle:
        return Shape::circle;
    case Model::rectangle:
        return Shape::rectangle;
    case Model::triangle:
        return Shape::triangle;
    case Model::arc:
        return Shape::arc;
    case Model::line:
        return Shape::line;
    default:
        return Shape::unknown;
    }
}

/// Whether an explanation by this model may describe the shape.
bool explains(Model model, Shape shape) {
    return shapeOf(shape == Shape::arc && model == Model::circle ? Model::arc : model) == shape;
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

/// Of the shapes except the point.
std::array<double, kShapes> shapeProbabilities(const Explanations& explanations, std::size_t points) {
    const ModelWeights weights = weigh(explanations, points);
    double total = kImpossibleEvidence;
    for (const double weight : weights)
        total = logSum(total, weight);
    std::array<double, kShapes> probability{};
    for (std::size_t m = 0; m < kModels; ++m)
        probability[index(shapeOf(static_cast<Model>(m)))] += std::exp(weights[m] - total);
    const std::size_t line = index(Shape::line);
    for (std::size_t i = 0; i < kShapes; ++i) {
        if (points > 3)
            probability[i] = (1.0 - kSurprise) * probability[i] + kSurprise * kPrior[i];
        else if (i != line) // three points tell nothing about the others
            probability[i] = (1.0 - probability[line]) * kPrior[i] / (1.0 - kPrior[line]);
    }
    return probability;
}

} // namespace

const char* toString(Shape shape) {
    static constexpr const char* kNames[kShapes] = {"circle", "rectangle", "triangle", "arc",
                                                    "line",   "point",     "unknown"};
    return kNames[index(shape)];
}

std::vector<Shape> Recognition::candidates() const {
    std::vector<Shape> all;
    for (std::size_t i = 0; i < kShapes; ++i)
        if (probability[i] > 0.0)
            all.push_back(static_cast<Shape>(i));
    if (all.empty())
        return {shape};
    std::ranges::stable_sort(all, std::ranges::greater{}, [&](Shape s) { return probability[index(s)]; });
    double sum = 0.0;
    const auto last =
        std::ranges::find_if(all, [&](Shape s) { return (sum += probability[index(s)]) >= kDecided; });
    if (last != all.end())
        all.erase(last + 1, all.end());
    return all;
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

    const Explanations explanations = explain(contour, settings.closed);
    const std::array<double, kShapes> shapes = shapeProbabilities(explanations, contour.points.size());
    for (std::size_t i = 0; i < kShapes; ++i)
        result.probability[i] += (1.0 - point) * shapes[i];
    decide(static_cast<Shape>(std::ranges::max_element(shapes) - shapes.begin()));

    const Explanation* best = nullptr;
    for (const Explanation& e : explanations.all)
        if (explains(e.model, result.shape) && (best == nullptr || e.logEvidence > best->logEvidence))
            best = &e;
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
        result.closed = named ? !ends : explanations.closed;
    }
    return result;
}

} // namespace teleta::contour
