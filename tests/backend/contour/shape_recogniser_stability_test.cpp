// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/polygon.h"
#include "backend/contour/shape_recogniser.h"
#include "tests/backend/contour/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace teleta::contour {
namespace {

Points noisy(Points points, double deviation_m, unsigned seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0.0, deviation_m);
    for (Point& p : points)
        p += Point(normal(engine), normal(engine));
    return points;
}

Points evenly(const Points& vertices, bool closed, int count, double laps = 1.0) {
    const Track track(vertices, closed);
    Points points;
    for (int i = 0; i < count; ++i) {
        double s = closed ? laps * i / count : static_cast<double>(i) / (count - 1);
        s -= closed ? std::floor(s) : 0.0;
        points.push_back(track.at(track.length() * s));
    }
    return points;
}

struct Named {
    Shape shape;
    Points points;
};

/// One shape of each kind, with a little noise so that nothing is exact.
std::vector<Named> examples(double noise_m = 0.0005) {
    return {
        {Shape::circle, noisy(circlePoints(30, 0.04), noise_m, 1)},
        {Shape::rectangle, noisy(evenly({{0, 0}, {0.08, 0}, {0.08, 0.05}, {0, 0.05}}, true, 36), noise_m, 2)},
        {Shape::triangle, noisy(evenly({{0, 0}, {0.09, 0}, {0.03, 0.07}}, true, 36), noise_m, 3)},
        {Shape::arc, noisy(evenly(ellipseVertices(0.05, 0.05, 0.3, 2.9), false, 24), noise_m, 4)},
        {Shape::line, noisy(evenly({{0, 0}, {0.05, 0.06}}, false, 20), noise_m, 5)},
        {Shape::unknown, noisy(evenly(ellipseVertices(0.06, 0.03, 0, 6.2831), true, 40), noise_m, 6)}};
}

} // namespace

TEST(ShapeRecogniserStability, noneToThreePointsHaveDefinedAnswers) {
    const auto none = recogniseShape({});
    EXPECT_EQ(none->shape, Shape::unknown);
    EXPECT_EQ(none->confidence, 0.0);

    const auto one = recogniseShape(Points{{0.1, 0.2}});
    EXPECT_EQ(one->shape, Shape::point);
    EXPECT_EQ(one->confidence, 1.0);

    const auto two = recogniseShape(Points{{0.0, 0.0}, {0.03, 0.04}});
    EXPECT_EQ(two->shape, Shape::line);
    EXPECT_NEAR(two->confidence, 0.5, 1e-6);
    EXPECT_EQ(two->vertices_m.size(), 2U);

    const auto straight = recogniseShape(Points{{0.0, 0.0}, {0.03, 0.04}, {0.06, 0.08}});
    EXPECT_EQ(straight->shape, Shape::line);
    EXPECT_LT(straight->confidence, 0.99); // three points prove little

    const auto bent = recogniseShape(Points{{0.0, 0.0}, {0.06, 0.0}, {0.03, 0.05}});
    EXPECT_EQ(bent->shape, Shape::unknown); // circle, arc and triangle all fit exactly
    EXPECT_GE(bent->candidates().size(), 4U);
    EXPECT_NEAR(std::accumulate(bent->probability.begin(), bent->probability.end(), 0.0), 1.0, 1e-12);
}

TEST(ShapeRecogniserStability, pointsThatRepeatAreAPointOrTheShapeOfThePlaces) {
    for (const std::size_t count : {2U, 3U, 7U, 500U}) {
        const auto same = recogniseShape(Points(count, Point(-0.3, 0.2)));
        EXPECT_EQ(same->shape, Shape::point);
        EXPECT_EQ(same->confidence, 1.0);
        EXPECT_EQ(same->outliers, 0U);
    }
    Points twoPlaces(10, Point(0.0, 0.0));
    std::fill(twoPlaces.begin() + 5, twoPlaces.end(), Point(0.05, 0.02));
    EXPECT_EQ(recogniseShape(twoPlaces)->shape, Shape::line);
    for (const Named& example : examples()) {
        Points repeated;
        for (const Point& p : example.points)
            repeated.insert(repeated.end(), 3, p);
        EXPECT_EQ(recogniseShape(repeated)->shape, example.shape);
    }
}

TEST(ShapeRecogniserStability, aClusterWithAFarPointIsAPointWithAnOutlier) {
    Points points(8, Point(0.1, 0.1));
    points[3] = {0.6, 0.1};
    const auto exact = recogniseShape(points);
    EXPECT_EQ(exact->shape, Shape::point);
    EXPECT_EQ(exact->outliers, 1U);
    const auto cloud = recogniseShape(noisy(points, 0.0003, 9));
    EXPECT_EQ(cloud->shape, Shape::point);
    EXPECT_EQ(cloud->outliers, 1U);
}

TEST(ShapeRecogniserStability, coordinatesThatAreNotFiniteAreRefused) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e200}) {
        Points points = circlePoints(12, 0.05);
        points[4].y() = bad;
        EXPECT_FALSE(recogniseShape(points).has_value());
        EXPECT_FALSE(findPolygon(points).has_value());
        EXPECT_FALSE(fitCircle(points).has_value());
    }
}

TEST(ShapeRecogniserStability, collinearPointsAreALineInEveryDirectionAndSpacing) {
    std::mt19937_64 engine(31);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int repeat = 0; repeat < 50; ++repeat) {
        const Point direction = onCircle(0.08, 6.3 * uniform(engine));
        Points points{Point::Zero(), direction};
        for (int i = 0; i < 10; ++i)
            points.push_back(uniform(engine) * direction);
        const auto seen = recogniseShape(points);
        EXPECT_EQ(seen->shape, Shape::line);
        EXPECT_LT(seen->rms_m, 1e-15);
    }
    // A vertical and a horizontal one, exactly.
    EXPECT_EQ(recogniseShape(evenly({{0, 0}, {0, 0.1}}, false, 9))->shape, Shape::line);
    EXPECT_EQ(recogniseShape(evenly({{0, 0}, {0.1, 0}}, false, 9))->shape, Shape::line);
}

TEST(ShapeRecogniserStability, shapesScaleWithTheResolutionFrom1e12ToItsInverse) {
    for (const Named& example : examples()) {
        const auto unit = recogniseShape(example.points);
        ASSERT_EQ(unit->shape, example.shape);
        for (const double scale : {1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e12}) {
            RecognitionSettings settings;
            settings.resolution_m *= scale;
            const auto scaled = recogniseShape(moved(example.points, scale, 0.0, Point::Zero()), settings);
            EXPECT_EQ(scaled->shape, example.shape) << scale;
            EXPECT_NEAR(scaled->confidence, unit->confidence, 1e-6);
            EXPECT_NEAR(scaled->rms_m / scale, unit->rms_m, 1e-6 * unit->rms_m);
        }
    }
}

TEST(ShapeRecogniserStability, shapesTurnAndMoveWithTheirPoints) {
    for (const Named& example : examples()) {
        const auto here = recogniseShape(example.points);
        for (const double angle_rad : {0.4, 1.6, 3.0, 5.5}) {
            const auto there = recogniseShape(moved(example.points, 1.0, angle_rad, {0.7, -2.0}));
            EXPECT_EQ(there->shape, example.shape) << angle_rad;
            EXPECT_NEAR(there->confidence, here->confidence, 0.01);
            ASSERT_EQ(there->circle.has_value(), here->circle.has_value());
            if (here->circle) {
                EXPECT_NEAR(there->circle->radius_m, here->circle->radius_m, 1e-6);
                EXPECT_LT((there->circle->centre_m -
                           moved({here->circle->centre_m}, 1.0, angle_rad, {0.7, -2.0}).front())
                              .norm(),
                          1e-6);
            }
        }
    }
}

TEST(ShapeRecogniserStability, theStartAndTheDirectionOfExplorationDoNotMatter) {
    for (const Named& example : examples()) {
        const bool open = example.shape == Shape::arc || example.shape == Shape::line;
        const auto usual = recogniseShape(example.points);
        Points points = example.points;
        std::reverse(points.begin(), points.end());
        EXPECT_EQ(recogniseShape(points)->shape, example.shape);
        EXPECT_NEAR(recogniseShape(points)->confidence, usual->confidence, 0.02);
        for (const int shift : {1, 7, 19}) {
            if (open)
                continue;
            std::rotate(points.begin(), points.begin() + shift, points.end());
            const auto seen = recogniseShape(points);
            EXPECT_EQ(seen->shape, example.shape) << shift;
            EXPECT_NEAR(seen->confidence, usual->confidence, 0.02);
        }
    }
}

TEST(ShapeRecogniserStability, aContourTraversedTwiceOrBackAndForthIsTheSameShape) {
    for (const Named& example : examples()) {
        const Points again = noisy(example.points, 0.0005, 77);
        Points twice = example.points;
        twice.insert(twice.end(), again.begin(), again.end());
        Points back = example.points;
        back.insert(back.end(), again.rbegin(), again.rend());
        EXPECT_EQ(recogniseShape(back)->shape, example.shape);
        if (example.shape != Shape::arc && example.shape != Shape::line) {
            EXPECT_EQ(recogniseShape(twice)->shape, example.shape);
        }
    }
}

TEST(ShapeRecogniserStability, anOutlierDoesNotChangeTheShape) {
    for (const Named& example : examples())
        for (const double distance_m : {0.03, 0.1, 1.0, 1e3})
            for (const std::size_t place : {0U, 4U, 13U}) {
                Points points = example.points;
                points[place] += Point(0.6 * distance_m, -0.8 * distance_m);
                const auto seen = recogniseShape(points);
                EXPECT_EQ(seen->shape, example.shape) << toString(example.shape) << ' ' << distance_m << ' '
                                                      << place << " -> " << toString(seen->shape);
            }
}

TEST(ShapeRecogniserStability, noiseOfFivePercentLeavesTheShapesOfDenseContours) {
    const std::vector<Named> dense = {
        {Shape::circle, noisy(circlePoints(60, 0.05), 0.005, 1)},
        {Shape::rectangle, noisy(evenly({{0, 0}, {0.1, 0}, {0.1, 0.07}, {0, 0.07}}, true, 60), 0.005, 2)},
        {Shape::triangle, noisy(evenly({{0, 0}, {0.1, 0}, {0.05, 0.0866}}, true, 60), 0.005, 3)},
        {Shape::arc, noisy(evenly(ellipseVertices(0.05, 0.05, 0.0, 3.14), false, 40), 0.005, 4)},
        {Shape::line, noisy(evenly({{0, 0}, {0.06, 0.08}}, false, 40), 0.005, 5)}};
    for (const Named& example : dense)
        EXPECT_EQ(recogniseShape(example.points)->shape, example.shape) << toString(example.shape);
}

TEST(ShapeRecogniserStability, pointsANanometreOrAKilometreApartHaveAShape) {
    RecognitionSettings nanometre;
    nanometre.resolution_m = 1e-10;
    EXPECT_EQ(recogniseShape(circlePoints(24, 4e-9), nanometre)->shape, Shape::circle);
    EXPECT_EQ(recogniseShape(circlePoints(24, 4e-9))->shape, Shape::point);
    EXPECT_EQ(recogniseShape(circlePoints(24, 4e3))->shape, Shape::circle);
    RecognitionSettings smaller;
    smaller.resolution_m = 1e-11;
    EXPECT_EQ(recogniseShape(circlePoints(24, 1e-9), smaller)->shape, Shape::circle);
    EXPECT_EQ(recogniseShape(circlePoints(24, 1e-9))->shape, Shape::point);
    EXPECT_EQ(recogniseShape(circlePoints(24, 1e9))->shape, Shape::circle);
    // Both in one contour: the nanometre steps are repeated points.
    Points mixed;
    for (const Point& p : evenly({{0, 0}, {3e3, 0}, {3e3, 2e3}, {0, 2e3}}, true, 24)) {
        mixed.push_back(p);
        mixed.push_back(p + Point(1e-9, 0.0));
    }
    EXPECT_EQ(recogniseShape(mixed)->shape, Shape::rectangle);
}

TEST(ShapeRecogniserStability, theCurvatureOfAnArcMayVanishOverTwelveDecades) {
    // 0.1 m of a circle of growing radius: first an arc, then a line, never anything else. The radius is
    // found as long as the sagitta is above the rounding of the coordinates.
    bool line = false;
    for (double radius_m = 0.05; radius_m < 1e11; radius_m *= 3.0) {
        Points points;
        for (int i = 0; i < 25; ++i) {
            const double angle_rad = (0.1 / radius_m) * (i / 24.0 - 0.5);
            points.emplace_back(radius_m * std::sin(angle_rad),
                                2.0 * radius_m * std::pow(std::sin(0.5 * angle_rad), 2));
        }
        const auto seen = recogniseShape(points);
        EXPECT_EQ(seen->shape, line || seen->shape == Shape::line ? Shape::line : Shape::arc) << radius_m;
        line = line || seen->shape == Shape::line;
        if (radius_m < 1e3) {
            // Sagitta 0.1^2/(8 R); coordinates of 0.1 m round at 1e-17.
            const auto circle = fitCircle(points);
            ASSERT_TRUE(circle.has_value()) << radius_m;
            EXPECT_NEAR(circle->radius_m / radius_m, 1.0, 1e-14 * radius_m / 0.00125 + 1e-11) << radius_m;
        }
    }
    EXPECT_TRUE(line);
}

TEST(ShapeRecogniserStability, manyPointsAreThinnedAndRecognised) {
    EXPECT_EQ(recogniseShape(circlePoints(100'000, 0.05))->shape, Shape::circle);
    EXPECT_EQ(recogniseShape(evenly({{0, 0}, {0.08, 0}, {0.08, 0.05}, {0, 0.05}}, true, 20'000))->shape,
              Shape::rectangle);
}

TEST(ShapeRecogniserStability, randomCloudsRaiseNoFloatingPointException) {
    std::mt19937_64 engine(41);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int repeat = 0; repeat < 300; ++repeat) {
        // Few places on a coarse grid, so that points repeat and align.
        Points points;
        const int count = 1 + repeat % 14;
        for (int i = 0; i < count; ++i)
            points.emplace_back(0.01 * std::round(3.0 * uniform(engine)),
                                0.01 * std::round(2.0 * uniform(engine)));
        const auto seen = recogniseShape(points);
        ASSERT_TRUE(seen.has_value());
        EXPECT_GE(seen->confidence, 0.0);
        EXPECT_LE(seen->confidence, 1.0 + 1e-12);
        const auto polygon = findPolygon(points);
        ASSERT_TRUE(polygon.has_value());
        for (const Point& p : polygon->vertices_m)
            EXPECT_TRUE(p.allFinite());
    }
}

} // namespace teleta::contour
