// SPDX-License-Identifier: GPL-3.0-or-later
// Curves: both cubic splines through a number of points on a circle, and Eigen's own spline interpolation.
// error_percent: largest deviation from the circle in the middle of a segment, in percent of its radius.
// Shapes: the recogniser, and the usual way with OpenCV (approxPolyDP with 4 % of the perimeter: three
// corners are a triangle, four a rectangle, more a circle). right_percent: share of correct answers over 300
// circles, rectangles and triangles in random poses; the noise is given in percent of the size.
#include "backend/contour/cubic_spline.h"
#include "backend/contour/shape_recogniser.h"
#include "tests/backend/contour/random_shapes.h"

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <unsupported/Eigen/Splines>
#include <vector>

namespace {

using namespace teleta::contour;

constexpr double kRadius_m = 0.05;
constexpr int kShapesOfEach = 100;

double errorPercent(double worst_m) {
    return 100.0 * worst_m / kRadius_m;
}

void splineOfAKind(benchmark::State& state, SplineKind kind) {
    const auto count = static_cast<int>(state.range(0));
    const Points points = circlePoints(count, kRadius_m);
    double worst_m = 0.0;
    for (auto _ : state) {
        const auto spline = CubicSpline::fit(points, kind, true);
        worst_m = 0.0;
        for (int i = 0; i < count; ++i)
            worst_m = std::max(worst_m, std::abs(spline->position_m(i + 0.5).norm() - kRadius_m));
        benchmark::DoNotOptimize(worst_m);
    }
    state.counters["error_percent"] = errorPercent(worst_m);
}

void splineApproximating(benchmark::State& state) {
    splineOfAKind(state, SplineKind::approximating);
}

void splineInterpolating(benchmark::State& state) {
    splineOfAKind(state, SplineKind::interpolating);
}

/// Eigen has no closed splines: the first point is repeated at the end, and the two segments next to it are
/// excluded from the error.
void splineEigen(benchmark::State& state) {
    const auto count = static_cast<int>(state.range(0));
    Eigen::Matrix2Xd points(2, count + 1);
    for (int i = 0; i <= count; ++i)
        points.col(i) = circlePoints(count, kRadius_m)[static_cast<std::size_t>(i % count)];
    const Eigen::RowVectorXd knots = Eigen::RowVectorXd::LinSpaced(count + 1, 0.0, 1.0);
    double worst_m = 0.0;
    for (auto _ : state) {
        const auto spline = Eigen::SplineFitting<Eigen::Spline2d>::Interpolate(points, 3, knots);
        worst_m = 0.0;
        for (int i = 2; i + 2 < count; ++i) {
            const Eigen::Vector2d p = spline((i + 0.5) / count);
            worst_m = std::max(worst_m, std::abs(p.norm() - kRadius_m));
        }
        benchmark::DoNotOptimize(worst_m);
    }
    state.counters["error_percent"] = errorPercent(worst_m);
}

struct Example {
    Shape shape;
    Points points_m;
};

std::vector<Example> examples(double noise) {
    RandomShapes random(3000);
    std::vector<Example> all;
    for (int i = 0; i < kShapesOfEach; ++i) {
        for (const Shape shape : {Shape::circle, Shape::rectangle, Shape::triangle}) {
            const Exploration e = random.exploration(noise, noise);
            const double size_m = random.uniform(0.02, 0.15);
            all.push_back({shape, shape == Shape::circle      ? random.circle(size_m, e)
                                  : shape == Shape::rectangle ? random.rectangle(size_m, e)
                                                              : random.triangle(size_m, e)});
        }
    }
    return all;
}

Shape byRecogniser(const Points& points_m) {
    return recogniseShape(points_m)->shape;
}

Shape byOpenCv(const Points& points_m) {
    std::vector<cv::Point2f> contour;
    for (const Point& p : points_m)
        contour.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    std::vector<cv::Point2f> corners;
    cv::approxPolyDP(contour, corners, 0.04 * cv::arcLength(contour, true), true);
    switch (corners.size()) {
    case 3:
        return Shape::triangle;
    case 4:
        return Shape::rectangle;
    default:
        return corners.size() > 4 ? Shape::circle : Shape::unknown;
    }
}

void recognise(benchmark::State& state, Shape (*by)(const Points&)) {
    const std::vector<Example> all = examples(static_cast<double>(state.range(0)) * 0.01);
    int right = 0;
    for (const Example& example : all)
        right += by(example.points_m) == example.shape ? 1 : 0;
    std::size_t next = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(by(all[next].points_m));
        next = (next + 1) % all.size();
    }
    state.counters["right_percent"] = 100.0 * right / static_cast<double>(all.size());
}

void shapeRecogniser(benchmark::State& state) {
    recognise(state, byRecogniser);
}

void shapeOpenCv(benchmark::State& state) {
    recognise(state, byOpenCv);
}

BENCHMARK(splineApproximating)->ArgName("points")->Arg(12)->Arg(36)->Arg(360);
BENCHMARK(splineInterpolating)->ArgName("points")->Arg(12)->Arg(36)->Arg(360);
BENCHMARK(splineEigen)->ArgName("points")->Arg(12)->Arg(36)->Arg(360);
BENCHMARK(shapeRecogniser)->ArgName("noise_percent")->Arg(0)->Arg(2)->Arg(5)->Unit(benchmark::kMicrosecond);
BENCHMARK(shapeOpenCv)->ArgName("noise_percent")->Arg(0)->Arg(2)->Arg(5)->Unit(benchmark::kMicrosecond);

} // namespace
