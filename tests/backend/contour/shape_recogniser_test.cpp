// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/shape_recogniser.h"
#include "tests/backend/contour/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace teleta::contour {
namespace {

constexpr double kPi = std::numbers::pi;

Points evenly(const Points& vertices, bool closed, int count) {
    const Track track(vertices, closed);
    Points points;
    for (int i = 0; i < count; ++i)
        points.push_back(track.at(track.length() * i / (closed ? count : count - 1)));
    return points;
}

Points arcOf(double radius_m, double angle_rad, int count) {
    Points points;
    for (int i = 0; i < count; ++i)
        points.push_back(onCircle(radius_m, angle_rad * i / (count - 1)));
    return points;
}

const Points kRectangle = {{0.0, 0.0}, {0.09, 0.0}, {0.09, 0.05}, {0.0, 0.05}};
const Points kTriangle = {{0.0, 0.0}, {0.1, 0.0}, {0.04, 0.07}};

void expectCorners(const std::vector<Point>& found, const Points& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (const Point& p : expected)
        EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Point& q) {
            return (p - q).norm() < 1e-9;
        })) << p.transpose();
}

} // namespace

TEST(ShapeRecogniser, recognisesACircleAndGivesItsCentreAndRadius) {
    const auto seen = recogniseShape(moved(circlePoints(24, 0.04), 1.0, 0.3, {0.2, 0.1}));
    ASSERT_TRUE(seen.has_value());
    EXPECT_EQ(seen->shape, Shape::circle);
    EXPECT_GT(seen->confidence, 0.95);
    EXPECT_TRUE(seen->closed);
    EXPECT_TRUE(seen->vertices_m.empty());
    ASSERT_TRUE(seen->circle.has_value());
    EXPECT_LT((seen->circle->centre_m - Point(0.2, 0.1)).norm(), 1e-12);
    EXPECT_NEAR(seen->circle->radius_m, 0.04, 1e-12);
    EXPECT_LT(seen->circle->rms_m, 1e-13);
}

TEST(ShapeRecogniser, recognisesARectangleAndGivesItsCorners) {
    const auto seen = recogniseShape(evenly(kRectangle, true, 30));
    ASSERT_TRUE(seen.has_value());
    EXPECT_EQ(seen->shape, Shape::rectangle);
    EXPECT_GT(seen->confidence, 0.95);
    EXPECT_TRUE(seen->closed);
    EXPECT_FALSE(seen->circle.has_value());
    expectCorners(seen->vertices_m, kRectangle);
}

TEST(ShapeRecogniser, aSquareIsARectangle) {
    const auto seen = recogniseShape(evenly({{0, 0}, {0.06, 0}, {0.06, 0.06}, {0, 0.06}}, true, 30));
    EXPECT_EQ(seen->shape, Shape::rectangle);
    EXPECT_GT(seen->confidence, 0.95);
}

TEST(ShapeRecogniser, recognisesATriangleAndGivesItsCornersCounterClockwise) {
    Points points = evenly(kTriangle, true, 30);
    for (int direction = 0; direction < 2; ++direction) {
        const auto seen = recogniseShape(points);
        ASSERT_TRUE(seen.has_value());
        EXPECT_EQ(seen->shape, Shape::triangle);
        EXPECT_GT(seen->confidence, 0.95);
        expectCorners(seen->vertices_m, kTriangle);
        const Point a = seen->vertices_m[1] - seen->vertices_m[0];
        const Point b = seen->vertices_m[2] - seen->vertices_m[0];
        EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0.0);
        std::reverse(points.begin(), points.end());
    }
}

TEST(ShapeRecogniser, anArcIsACirclePartOfWhichWasTouched) {
    for (const double angle_rad : {0.35 * kPi, 0.5 * kPi, kPi, 1.5 * kPi, 1.7 * kPi}) {
        const auto seen = recogniseShape(arcOf(0.05, angle_rad, 40));
        ASSERT_TRUE(seen.has_value());
        EXPECT_EQ(seen->shape, Shape::arc) << angle_rad;
        // A circle of which 54 degrees were not touched is nearly as probable.
        EXPECT_GT(seen->confidence, angle_rad < 1.6 * kPi ? 0.9 : 0.5) << angle_rad;
        EXPECT_FALSE(seen->closed);
        ASSERT_TRUE(seen->circle.has_value());
        EXPECT_LT(seen->circle->centre_m.norm(), 1e-9);
        EXPECT_NEAR(seen->circle->radius_m, 0.05, 1e-9);
    }
    EXPECT_EQ(recogniseShape(arcOf(0.05, 1.8 * kPi, 40))->shape, Shape::circle);
}

TEST(ShapeRecogniser, recognisesALineAndGivesItsEnds) {
    const auto seen = recogniseShape(evenly({{0.01, 0.02}, {0.07, 0.1}}, false, 15));
    ASSERT_TRUE(seen.has_value());
    EXPECT_EQ(seen->shape, Shape::line);
    EXPECT_GT(seen->confidence, 0.95);
    EXPECT_FALSE(seen->closed);
    expectCorners(seen->vertices_m, {{0.01, 0.02}, {0.07, 0.1}});
}

TEST(ShapeRecogniser, anExtentUnderTheResolutionIsAPoint) {
    const Points points = circlePoints(12, 0.0016);
    const auto seen = recogniseShape(points);
    EXPECT_EQ(seen->shape, Shape::point);
    EXPECT_TRUE(seen->vertices_m.empty());
    EXPECT_FALSE(seen->circle.has_value());

    RecognitionSettings fine;
    fine.resolution_m = 0.0005;
    EXPECT_EQ(recogniseShape(points, fine)->shape, Shape::circle);

    // At the resolution it is as much a point as not.
    fine.resolution_m = 0.0032 * (1.0 + 1e-9);
    EXPECT_EQ(recogniseShape(points, fine)->shape, Shape::point);
    EXPECT_NEAR(recogniseShape(points, fine)->confidence, 0.5, 1e-6);
    fine.resolution_m = 0.0032 * (1.0 - 1e-9);
    EXPECT_EQ(recogniseShape(points, fine)->shape, Shape::circle);
    fine.resolution_m = 0.0;
    EXPECT_EQ(recogniseShape(points, fine)->shape, Shape::circle);
}

TEST(ShapeRecogniser, anEllipseAPentagonAnLAndAnSAreUnknown) {
    const Points lShape = {{0, 0}, {0.1, 0}, {0.1, 0.04}, {0.04, 0.04}, {0.04, 0.1}, {0, 0.1}};
    Points wave;
    for (int i = 0; i < 40; ++i)
        wave.emplace_back(0.0025 * i, 0.02 * std::sin(2.0 * kPi * i / 40));
    Points ellipse;
    for (int i = 0; i < 40; ++i)
        ellipse.emplace_back(0.06 * std::cos(2.0 * kPi * i / 40), 0.04 * std::sin(2.0 * kPi * i / 40));
    for (const Points& points :
         {ellipse, evenly(regularPolygon(5, 0.1), true, 40), evenly(lShape, true, 40), wave}) {
        const auto seen = recogniseShape(points);
        EXPECT_EQ(seen->shape, Shape::unknown) << toString(seen->shape);
        EXPECT_GT(seen->confidence, 0.9);
        EXPECT_FALSE(seen->circle.has_value());
    }
    const auto seen = recogniseShape(evenly(lShape, true, 40));
    EXPECT_TRUE(seen->closed);
    expectCorners(seen->vertices_m, lShape);
    EXPECT_FALSE(recogniseShape(wave)->closed);
}

TEST(ShapeRecogniser, threeSidesOfARectangleAreNoRectangle) {
    const auto seen = recogniseShape(evenly({{0, 0.05}, {0, 0}, {0.09, 0}, {0.09, 0.05}}, false, 30));
    EXPECT_EQ(seen->shape, Shape::unknown);
}

TEST(ShapeRecogniser, probabilitiesSumToOneAndTheConfidenceIsThatOfTheShape) {
    RandomShapes random(3);
    for (int repeat = 0; repeat < 20; ++repeat) {
        const Exploration e = random.exploration(0.05);
        for (const Points& points :
             {random.circle(0.08, e), random.rectangle(0.08, e), random.randomWalk(0.08, e)}) {
            const auto seen = recogniseShape(points);
            ASSERT_TRUE(seen.has_value());
            EXPECT_NEAR(std::accumulate(seen->probability.begin(), seen->probability.end(), 0.0), 1.0, 1e-12);
            EXPECT_EQ(seen->confidence, seen->probability[static_cast<std::size_t>(seen->shape)]);
            EXPECT_EQ(seen->confidence,
                      *std::max_element(seen->probability.begin(), seen->probability.end()));
        }
    }
}

TEST(ShapeRecogniser, theCandidatesAreTheFewestShapesThatHoldNineTenths) {
    Recognition seen;
    EXPECT_EQ(seen.candidates(), std::vector{Shape::unknown});
    seen.shape = Shape::circle;
    seen.probability = {0.55, 0.2, 0.0, 0.05, 0.0, 0.0, 0.2};
    EXPECT_EQ(seen.candidates(), (std::vector{Shape::circle, Shape::rectangle, Shape::unknown}));
    seen.probability = {0.9, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0};
    EXPECT_EQ(seen.candidates(), std::vector{Shape::circle});
}

TEST(ShapeRecogniser, theFourCornersOfASquareLeaveMoreThanOneShape) {
    const auto seen = recogniseShape(Points{{0, 0}, {0.06, 0}, {0.06, 0.06}, {0, 0.06}});
    EXPECT_GT(seen->candidates().size(), 1U);
    EXPECT_LT(seen->confidence, 0.9);
    EXPECT_LT(seen->probability[static_cast<std::size_t>(Shape::circle)], 0.2);
    // The middles of its edges are as well four points of a circle.
    const auto middles = recogniseShape(Points{{0.03, 0}, {0.06, 0.03}, {0.03, 0.06}, {0, 0.03}});
    EXPECT_GT(middles->candidates().size(), 1U);
    EXPECT_LT(middles->confidence, 0.7);
}

TEST(ShapeRecogniser, twentyPointsOfTwoCirclesApartAreNoNamedShape) {
    Points points = circlePoints(10, 0.03);
    for (const Point& p : circlePoints(10, 0.03))
        points.push_back(p + Point(0.08, 0.0));
    EXPECT_EQ(recogniseShape(points)->shape, Shape::unknown);
}

TEST(ShapeRecogniser, toldClosednessIsKept) {
    RecognitionSettings settings;
    settings.closed = true;
    EXPECT_TRUE(recogniseShape(arcOf(0.05, kPi, 20), settings)->closed);
    settings.closed = false;
    EXPECT_FALSE(recogniseShape(circlePoints(20, 0.05), settings)->closed);
}

TEST(ShapeRecogniser, namesAreThoseOfTheCommandLine) {
    EXPECT_STREQ(toString(Shape::circle), "circle");
    EXPECT_STREQ(toString(Shape::rectangle), "rectangle");
    EXPECT_STREQ(toString(Shape::triangle), "triangle");
    EXPECT_STREQ(toString(Shape::arc), "arc");
    EXPECT_STREQ(toString(Shape::line), "line");
    EXPECT_STREQ(toString(Shape::point), "point");
    EXPECT_STREQ(toString(Shape::unknown), "unknown");
}

} // namespace teleta::contour
