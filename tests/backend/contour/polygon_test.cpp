// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/contour_order.h"
#include "backend/contour/polygon.h"
#include "tests/backend/contour/random_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace teleta::contour {
namespace {

const Points kSquare = {{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.1}, {0.0, 0.1}};
const Points kTriangle = {{0.0, 0.0}, {0.12, 0.0}, {0.03, 0.09}};
const Points kPentagon = {{0.0, 0.0}, {0.08, -0.01}, {0.11, 0.06}, {0.05, 0.11}, {-0.02, 0.07}};
const Points kLShape = {{0.0, 0.0}, {0.12, 0.0}, {0.12, 0.04}, {0.04, 0.04}, {0.04, 0.12}, {0.0, 0.12}};
const Points kArrow = {{0.0, 0.0}, {0.1, 0.06}, {0.0, 0.12}, {0.03, 0.06}};
const Points kZigzag = {{0.0, 0.0}, {0.05, 0.06}, {0.10, 0.0}, {0.15, 0.06}};
const Points kCorner = {{0.0, 0.1}, {0.0, 0.0}, {0.07, 0.0}};

/// count points evenly along a track from a start, as a share of its length.
Points walk(const Points& vertices, bool closed, int count, double start = 0.0, double laps = 1.0) {
    const Track track(vertices, closed);
    Points points;
    for (int i = 0; i < count; ++i) {
        double s = closed ? start + laps * i / count : static_cast<double>(i) / (count - 1);
        s -= closed ? std::floor(s) : 0.0;
        points.push_back(track.at(s * track.length()));
    }
    return points;
}

double distanceToNearest(const Points& vertices, const Point& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Point& v : vertices)
        least = std::min(least, (v - p).norm());
    return least;
}

void expectVertices(const Polygon& polygon, const Points& expected, double tolerance_m) {
    ASSERT_EQ(polygon.vertices_m.size(), expected.size());
    for (const Point& p : expected)
        EXPECT_LT(distanceToNearest(polygon.vertices_m, p), tolerance_m) << p.transpose();
}

} // namespace

TEST(Polygon, findsTheVerticesOfAnyPolygonInBothDirections) {
    for (const Points& shape : {kSquare, kTriangle, kPentagon, kLShape, kArrow})
        for (const double start : {0.0, 0.013, 0.37, 0.81})
            for (const bool reversed : {false, true}) {
                Points points = walk(shape, true, 48, start);
                if (reversed)
                    std::reverse(points.begin(), points.end());
                const auto polygon = findPolygon(points);
                ASSERT_TRUE(polygon.has_value());
                EXPECT_TRUE(polygon->closed);
                EXPECT_EQ(polygon->edges(), shape.size());
                expectVertices(*polygon, shape, 1e-9);
                EXPECT_LT(polygon->rms_m, 1e-9);
            }
}

TEST(Polygon, verticesComeInTheOrderOfExploration) {
    Points points = walk(kPentagon, true, 40, 0.3);
    for (const bool reversed : {false, true}) {
        const auto polygon = findPolygon(points);
        ASSERT_TRUE(polygon.has_value());
        ASSERT_EQ(polygon->vertices_m.size(), 5U);
        double area_m2 = 0.0;
        for (std::size_t i = 0; i < 5; ++i) {
            const Point& a = polygon->vertices_m[i];
            const Point& b = polygon->vertices_m[(i + 1) % 5];
            area_m2 += 0.5 * (a.x() * b.y() - a.y() * b.x());
        }
        EXPECT_EQ(area_m2 < 0.0, reversed);
        std::reverse(points.begin(), points.end());
    }
}

TEST(Polygon, anOpenContourHasItsEndsAsFirstAndLastVertex) {
    for (const Points& shape : {kZigzag, kCorner}) {
        const auto polygon = findPolygon(walk(shape, false, 31));
        ASSERT_TRUE(polygon.has_value());
        EXPECT_FALSE(polygon->closed);
        EXPECT_EQ(polygon->edges(), shape.size() - 1);
        expectVertices(*polygon, shape, 1e-9);
        EXPECT_LT((polygon->vertices_m.front() - shape.front()).norm(), 1e-9);
        EXPECT_LT((polygon->vertices_m.back() - shape.back()).norm(), 1e-9);
    }
}

TEST(Polygon, aStraightContourIsOneEdge) {
    const auto polygon = findPolygon(walk({{0.02, 0.01}, {0.08, 0.05}}, false, 12));
    ASSERT_TRUE(polygon.has_value());
    EXPECT_FALSE(polygon->closed);
    expectVertices(*polygon, {{0.02, 0.01}, {0.08, 0.05}}, 1e-12);
}

TEST(Polygon, closednessIsTakenAsToldAndFoundOtherwise) {
    // A square whose fourth side was not touched: open, three edges; told closed, four.
    const Points points = walk({{0.0, 0.1}, {0.0, 0.0}, {0.1, 0.0}, {0.1, 0.1}}, false, 31);
    const auto found = findPolygon(points);
    ASSERT_TRUE(found.has_value());
    EXPECT_FALSE(found->closed);
    EXPECT_EQ(found->edges(), 3U);
    const auto told = findPolygon(points, true);
    ASSERT_TRUE(told.has_value());
    EXPECT_TRUE(told->closed);

    EXPECT_TRUE(findPolygon(walk(kSquare, true, 40))->closed);
    EXPECT_FALSE(findPolygon(walk(kSquare, true, 40), false)->closed);
}

TEST(Polygon, aContourTraversedTwiceHasItsVerticesOnce) {
    for (const Points& shape : {kSquare, kTriangle, kPentagon, kLShape}) {
        const auto polygon = findPolygon(walk(shape, true, 90, 0.11, 2.0));
        ASSERT_TRUE(polygon.has_value());
        EXPECT_TRUE(polygon->closed);
        expectVertices(*polygon, shape, 1e-9);
    }
}

TEST(Polygon, anOutlierMovesNoVertex) {
    for (const Points& shape : {kSquare, kTriangle, kPentagon}) {
        Points points = walk(shape, true, 48, 0.013);
        points[5] += Point(0.01, -0.08);
        const auto polygon = findPolygon(points);
        ASSERT_TRUE(polygon.has_value());
        expectVertices(*polygon, shape, 1e-9);
        EXPECT_EQ(polygon->outliers, 1U);
    }
}

TEST(Polygon, withNoiseOfFivePercentTheVerticesAreWithinThatNoise) {
    // 60 points, 5 % of the size: an edge of 15 to 20 points is known to about a third of the noise across
    // it.
    RandomShapes random(5);
    constexpr int kRepeats = 50;
    int right = 0;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        Exploration e;
        e.points = 60;
        e.noise = 0.05;
        e.laps = 59.0 / 60.0;
        e.start = random.uniform(0.0, 1.0);
        e.reversed = repeat % 2 == 1;
        const auto polygon = findPolygon(random.explore(Track(kSquare, true), true, 0.1, e));
        ASSERT_TRUE(polygon.has_value());
        bool near = polygon->vertices_m.size() == 4;
        for (const Point& p : kSquare)
            near = near && distanceToNearest(polygon->vertices_m, p) < 2.0 * 0.05 * 0.1;
        right += near ? 1 : 0;
    }
    RecordProperty("squaresRight_of_50", right);
    EXPECT_GE(right, 40);
}

TEST(Polygon, scalesTurnsAndMovesWithItsPoints) {
    const Points points = walk(kPentagon, true, 40, 0.2);
    for (const double scale : {1e-9, 1e-3, 1.0, 1e3, 1e12}) {
        const Point shift_m = scale * Point(0.4, -0.7);
        const auto polygon = findPolygon(moved(points, scale, 1.1, shift_m));
        ASSERT_TRUE(polygon.has_value());
        expectVertices(*polygon, moved(kPentagon, scale, 1.1, shift_m), 1e-9 * scale);
    }
}

TEST(Polygon, degenerateContoursHaveNoVerticesAndUnusableOnesNoAnswer) {
    EXPECT_TRUE(findPolygon({})->vertices_m.empty());
    EXPECT_TRUE(findPolygon(Points{{0.1, 0.2}})->vertices_m.empty());
    EXPECT_TRUE(findPolygon(Points(9, Point(0.1, 0.2)))->vertices_m.empty());
    EXPECT_EQ(findPolygon(Points{})->edges(), 0U);
    EXPECT_EQ(findPolygon(Points{{0.0, 0.0}, {0.1, 0.0}})->vertices_m.size(), 2U);
    EXPECT_EQ(findPolygon(Points{{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.1}}, true)->edges(), 1U);
    EXPECT_FALSE(findPolygon(Points{{0.0, std::numeric_limits<double>::infinity()}}).has_value());
}

TEST(ChainFitter, chainsHardlyEverExceedTheirExpectation) {
    RandomShapes random(31);
    int fitted = 0;
    int exceeded = 0;
    for (int i = 0; i < 100; ++i)
        for (const Points& points_m :
             {random.circle(0.1, random.exploration(0.02)), random.triangle(0.1, random.exploration(0.02)),
              random.pentagon(0.1, random.exploration(0.02))}) {
            const PreparedContour contour = prepare(points_m);
            const ChainFitter fitter(contour.points, contour.points, true, 8);
            const EdgeRuns runs(contour.points, true, 8);
            for (const ChainFit& chain : fitter.fitFrom(4)) {
                ++fitted;
                const double most =
                    evidenceToExpect(contour.points.size(), 2 * chain.edges, runs.leastSquares(chain.edges),
                                     polylineLength(chain.fit.parameters, true));
                exceeded += chain.evidence.logEvidence > most ? 1 : 0;
                // A rival just above leaves this chain out, a rival far below does not.
                const double length = polylineLength(chain.fit.parameters, true);
                const auto isFitted = [&](double rival) {
                    const auto chains = fitter.fitFrom(chain.edges, {rival, length});
                    return !chains.empty() && chains.front().edges == chain.edges;
                };
                EXPECT_FALSE(isFitted(most + 1.0));
                EXPECT_TRUE(isFitted(most - 1.0));
            }
        }
    EXPECT_GT(fitted, 500);
    EXPECT_LE(exceeded, fitted / 50);
}

TEST(ContourOrder, aLapIsTheSameFromAnyPointInEitherDirection) {
    Points lap = walk(kPentagon, true, 11);
    Points other = lap;
    std::rotate(other.begin(), other.begin() + 4, other.end());
    EXPECT_TRUE(isSameLap(lap, other));
    std::reverse(other.begin(), other.end());
    EXPECT_TRUE(isSameLap(lap, other));
    std::swap(other[2], other[3]);
    EXPECT_FALSE(isSameLap(lap, other));
    other.pop_back();
    EXPECT_FALSE(isSameLap(lap, other));
    EXPECT_FALSE(isSameLap({}, {}));
}

} // namespace teleta::contour
