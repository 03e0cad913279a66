// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/shape_prior.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::contour {

namespace {

constexpr double kFewestPoints = 4.0;
constexpr double kMiddlePoints = 12.0;
constexpr double kMostPoints = 60.0;

/// Log prior of a model for twelve points, and its growth with the logarithm of the number of points.
struct ModelPrior {
    double base;
    double growth;
};

/// When the rest of a closed curve was left out on purpose.
struct PartPrior {
    double share; ///< left out in as many parts as wholes
    double softness;
    double softnessOfPoint; ///< divided by the number of points
    double untouchedEdge;
    double untouchedEdgeGrowth;
};

constexpr std::array<ModelPrior, kModels> kPriors = {{
    {5.09, 2.31}, // line
    {3.78, 0.53}, // circle
    {3.35, 0.90}, // arc
    {5.05, 1.98}, // triangle
    {5.11, 0.80}, // rectangle
    {2.26, 1.46}, // part of a triangle
    {1.25, 0.31}, // part of a rectangle
    {1.60, 0.60}, // ellipse
    {2.30, 1.37}, // regular polygon
    {2.33, 1.68}, // chain
    {2.18, 1.35}, // roughly
    {4.41, 1.03}, // walk
    {0.00, 0.00}, // scatter
}};
constexpr std::array kTemperPoints = {4.0, 6.0, 9.0, 15.0, 30.0, 60.0};
constexpr std::array kTemper = {0.303, 0.598, 0.707, 0.712, 0.600, 0.430};
constexpr PartPrior kArc = {0.125, 0.0053, 0.502, 0.0, 0.0};
constexpr PartPrior kPartOfPolygon = {0.093, 0.0201, 0.872, 1.05, -0.62};

/// Linear in the logarithm of the number of points between those of the table.
double temper(double points) {
    std::size_t next = 1;
    while (next + 1 < kTemper.size() && kTemperPoints[next] < points)
        ++next;
    const double share =
        std::log(points / kTemperPoints[next - 1]) / std::log(kTemperPoints[next] / kTemperPoints[next - 1]);
    return std::exp(std::lerp(std::log(kTemper[next - 1]), std::log(kTemper[next]), share));
}

double logLogistic(double x) {
    return x < 0.0 ? x - std::log1p(std::exp(x)) : -std::log1p(std::exp(-x));
}

std::size_t indexOf(Model model) {
    return static_cast<std::size_t>(model);
}

} // namespace

ModelWeights weigh(const Explanations& explanations, std::size_t points) {
    const double n = std::clamp(static_cast<double>(points), kFewestPoints, kMostPoints);
    const double growth = std::log(n / kMiddlePoints);
    ModelWeights weights;
    weights.fill(kImpossibleEvidence);
    for (const Explanation& e : explanations.all) {
        double& sum = weights[indexOf(e.model)];
        sum = logSum(sum, e.logEvidence);
    }
    weights[indexOf(Model::arc)] = weights[indexOf(Model::circle)];
    weights[indexOf(Model::partOfTriangle)] = weights[indexOf(Model::triangle)];
    weights[indexOf(Model::partOfRectangle)] = weights[indexOf(Model::rectangle)];
    const double exponent = temper(n);
    for (std::size_t m = 0; m < kModels; ++m)
        weights[m] = exponent * weights[m] + kPriors[m].base + kPriors[m].growth * growth;

    const auto divide = [&](Model whole, Model part, const PartPrior& prior) {
        for (const Explanation& e : explanations.all) {
            if (e.model != whole)
                continue;
            double odds = (e.untouched - prior.share) / (prior.softness + prior.softnessOfPoint / n);
            if (!e.everyEdge)
                odds += prior.untouchedEdge + prior.untouchedEdgeGrowth * growth;
            weights[indexOf(whole)] += logLogistic(-odds);
            weights[indexOf(part)] += logLogistic(odds);
        }
    };
    divide(Model::circle, Model::arc, kArc);
    divide(Model::triangle, Model::partOfTriangle, kPartOfPolygon);
    divide(Model::rectangle, Model::partOfRectangle, kPartOfPolygon);
    return weights;
}

} // namespace teleta::contour
