// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/cubic_spline.h"
#include "tests/backend/contour/contour_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace teleta::contour {
namespace {

constexpr SplineKind kKinds[] = {SplineKind::approximating, SplineKind::interpolating};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double largestCurvature_perM(const CubicSpline& spline) {
    double largest = 0.0;
    const int steps = 16 * static_cast<int>(spline.segments());
    for (int step = 0; step <= steps; ++step)
        largest = std::max(largest, std::abs(spline.curvature_perM(step / 16.0)));
    return largest;
}

} // namespace

TEST(CubicSplineStability, refusesNoPointsAndCoordinatesThatAreNotFinite) {
    for (const auto kind : kKinds)
        for (const bool closed : {false, true}) {
            EXPECT_FALSE(CubicSpline::fit({}, kind, closed).has_value());
            for (const double bad : {kNaN, kInfinity, -kInfinity, 1e200}) {
                const Points points = {{0.0, 0.0}, {1.0, bad}, {2.0, 1.0}};
                EXPECT_FALSE(CubicSpline::fit(points, kind, closed).has_value());
            }
        }
}

TEST(CubicSplineStability, onePointIsACurveThatStaysThere) {
    const Points points = {{0.3, -0.2}};
    for (const auto kind : kKinds)
        for (const bool closed : {false, true}) {
            const auto spline = CubicSpline::fit(points, kind, closed);
            EXPECT_EQ(spline->segments(), 0U);
            EXPECT_EQ(spline->position_m(0.7), points[0]);
            EXPECT_EQ(spline->derivative_m(0.7), Point::Zero());
            EXPECT_EQ(spline->curvature_perM(0.0), 0.0);
            EXPECT_EQ(spline->length_m(), 0.0);
        }
}

TEST(CubicSplineStability, twoPointsAreASegmentAndClosedTheSegmentThereAndBack) {
    const Points points = {{0.0, 0.0}, {0.3, 0.4}};
    for (const auto kind : kKinds) {
        const auto open = CubicSpline::fit(points, kind, false);
        EXPECT_NEAR(open->length_m(), 0.5, 1e-12);
        EXPECT_EQ(largestCurvature_perM(*open), 0.0);
    }
    const auto closed = CubicSpline::fit(points, SplineKind::interpolating, true);
    EXPECT_NEAR(closed->length_m(), 1.0, 1e-9);
    EXPECT_EQ(largestCurvature_perM(*closed), 0.0);
}

TEST(CubicSplineStability, threePointsOfAClosedCurveSolveTheCyclicSystem) {
    // The circulant (1 4 1)/6 of three points on a circle scales them by 3/(2 + cos 120 deg) = 2.
    const Points points = circlePoints(3, 0.04);
    const auto spline = CubicSpline::fit(points, SplineKind::interpolating, true);
    const Point middle = 2.0 * (points[2] + 23.0 * points[0] + 23.0 * points[1] + points[2]) / 48.0; // (9)
    EXPECT_LT((spline->position_m(0.5) - middle).norm(), 1e-16);
}

TEST(CubicSplineStability, pointsThatRepeatHaveNoCurvatureWhereTheCurveStandsStill) {
    for (const auto kind : kKinds) {
        const Points same(5, Point(0.1, 0.2));
        const auto standing = CubicSpline::fit(same, kind, true);
        EXPECT_EQ(largestCurvature_perM(*standing), 0.0);
        EXPECT_EQ(standing->length_m(), 0.0);
        EXPECT_EQ(standing->position_m(2.5), same[0]);
    }
    // Four equal control points in an approximating curve pin a whole segment to one place.
    const Points pinned = {{0, 0}, {1, 0}, {2, 1}, {2, 1}, {2, 1}, {2, 1}, {3, 0}};
    const auto spline = CubicSpline::fit(pinned, SplineKind::approximating, false);
    for (const double t : {3.0, 3.3, 3.9}) {
        EXPECT_LT((spline->position_m(t) - pinned[3]).norm(), 1e-15);
        EXPECT_EQ(spline->curvature_perM(t), 0.0);
    }
    EXPECT_TRUE(std::isfinite(spline->length_m()));
}

TEST(CubicSplineStability, collinearPointsHaveNoCurvatureInAnyDirectionAtAnyScale) {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (const double scale : {1e-12, 1e-9, 1e-3, 1.0, 1e3, 1e12})
        for (int repeat = 0; repeat < 50; ++repeat) {
            const Point direction = onCircle(1.0, 3.2 * uniform(engine));
            const Point start = scale * Point(uniform(engine), uniform(engine));
            Points points;
            for (int i = 0; i < 12; ++i)
                points.push_back(start + scale * uniform(engine) * direction);
            for (const auto kind : kKinds)
                for (const bool closed : {false, true}) {
                    const auto spline = CubicSpline::fit(points, kind, closed);
                    EXPECT_EQ(largestCurvature_perM(*spline), 0.0) << scale;
                }
        }
}

TEST(CubicSplineStability, aCuspHasCurvatureZeroAndALength) {
    // Symmetric about the y axis; with u = v = 1/2 the derivative (c2 - c0)/8 + 3(c2 - c1)/4 + ... vanishes
    // when c3 - c0 = -5 (c2 - c1): the middle of the segment is a cusp.
    const Points control = {{5.0, 0.0}, {-1.0, 1.0}, {1.0, 1.0}, {-5.0, 0.0}};
    const auto spline = CubicSpline::fit(control, SplineKind::approximating, false);
    EXPECT_EQ(spline->derivative_m(1.5), Point::Zero());
    EXPECT_EQ(spline->curvature_perM(1.5), 0.0);
    EXPECT_GT(std::abs(spline->curvature_perM(1.5001)), 1e3);

    // Length against the sum of a million chords, which lie below it by less than 1e-9.
    double chords_m = 0.0;
    constexpr int kChords = 1'000'000;
    Point previous = spline->position_m(0.0);
    for (int i = 1; i <= kChords; ++i) {
        const Point next = spline->position_m(3.0 * i / kChords);
        chords_m += (next - previous).norm();
        previous = next;
    }
    EXPECT_NEAR(spline->length_m(), chords_m, 1e-8 * chords_m);
}

TEST(CubicSplineStability, pointsANanometreAndAKilometreApartInOneContourGiveFiniteCurves) {
    const Points mixed = {{0.0, 0.0},   {1e-9, 0.0},         {1e-9, 1e-9},
                          {1e3, 0.5e3}, {1e3, 0.5e3 + 1e-9}, {0.0, 1e3}};
    for (const auto kind : kKinds)
        for (const bool closed : {false, true}) {
            const auto spline = CubicSpline::fit(mixed, kind, closed);
            EXPECT_TRUE(std::isfinite(largestCurvature_perM(*spline)));
            EXPECT_GT(spline->length_m(), 1e3);
            EXPECT_LT(spline->length_m(), 1e4);
        }
    const auto spline = CubicSpline::fit(mixed, SplineKind::interpolating, false);
    for (std::size_t i = 0; i < mixed.size(); ++i)
        EXPECT_LT((spline->position_m(static_cast<double>(i)) - mixed[i]).norm(), 4e-13) << i;
}

TEST(CubicSplineStability, resultsScaleFrom1e12ToItsInverse) {
    for (const double scale : {1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e12})
        for (const auto kind : kKinds) {
            const auto unit = CubicSpline::fit(circlePoints(24), kind, true);
            const auto scaled = CubicSpline::fit(circlePoints(24, scale), kind, true);
            EXPECT_NEAR(scaled->length_m() / scale, unit->length_m(), 1e-12);
            for (const double t : {0.0, 0.5, 7.25}) {
                EXPECT_NEAR(scaled->curvature_perM(t) * scale, unit->curvature_perM(t), 1e-12);
                EXPECT_LT((scaled->position_m(t) / scale - unit->position_m(t)).norm(), 1e-14);
            }
        }
}

TEST(CubicSplineStability, curvatureFarFromTheOriginLosesOnlyWhatTheCoordinatesLost) {
    // Shifted by s the coordinates keep s * eps; second differences of points 2 pi R/24 apart see it as
    // s * eps / (R (2 pi/24)^2) of the curvature.
    for (double shift_m = 1.0; shift_m < 1e9; shift_m *= 10.0) {
        const auto spline = CubicSpline::fit(moved(circlePoints(24), 1.0, 0.0, {shift_m, -shift_m}),
                                             SplineKind::interpolating, true);
        const auto unit = CubicSpline::fit(circlePoints(24), SplineKind::interpolating, true);
        const double error = std::abs(spline->curvature_perM(3.5) - unit->curvature_perM(3.5));
        EXPECT_LT(error, 50.0 * shift_m * std::numeric_limits<double>::epsilon() + 1e-14) << shift_m;
    }
}

TEST(CubicSplineStability, movesAndTurnsWithItsPointsAndKeepsItsCurvature) {
    const Points points = {{0.0, 0.0}, {0.02, 0.01}, {0.03, 0.04}, {0.01, 0.05}, {-0.02, 0.02}};
    const Points turned = moved(points, 1.0, 0.7, {0.3, -0.1});
    for (const auto kind : kKinds)
        for (const bool closed : {false, true}) {
            const auto one = CubicSpline::fit(points, kind, closed);
            const auto other = CubicSpline::fit(turned, kind, closed);
            EXPECT_NEAR(one->length_m(), other->length_m(), 1e-13);
            for (const double t : {0.3, 1.5, 3.9}) {
                EXPECT_LT(
                    (moved({one->position_m(t)}, 1.0, 0.7, {0.3, -0.1})[0] - other->position_m(t)).norm(),
                    1e-15);
                EXPECT_NEAR(one->curvature_perM(t), other->curvature_perM(t),
                            1e-9 * std::abs(one->curvature_perM(t)));
            }
        }
}

TEST(CubicSplineStability, aClosedCurveDoesNotDependOnWhereItsPointsBegin) {
    Points points = {{0.0, 0.0}, {0.02, 0.01}, {0.03, 0.04}, {0.01, 0.05}, {-0.02, 0.02}};
    for (const auto kind : kKinds) {
        const auto one = CubicSpline::fit(points, kind, true);
        Points later = points;
        std::rotate(later.begin(), later.begin() + 2, later.end());
        const auto other = CubicSpline::fit(later, kind, true);
        for (const double t : {0.0, 0.4, 2.7})
            EXPECT_LT((one->position_m(t + 2.0) - other->position_m(t)).norm(), 1e-16);
        Points reversed = points;
        std::reverse(reversed.begin(), reversed.end());
        const auto back = CubicSpline::fit(reversed, kind, true);
        for (const double t : {0.0, 0.4, 2.7}) {
            EXPECT_LT((one->position_m(4.0 - t) - back->position_m(t)).norm(), 1e-16);
            EXPECT_NEAR(one->curvature_perM(4.0 - t), -back->curvature_perM(t), 1e-9);
        }
    }
}

TEST(CubicSplineStability, aContourTraversedTwiceIsTheSameCurveTwice) {
    const Points once = circlePoints(16, 0.03);
    Points twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    for (const auto kind : kKinds) {
        const auto one = CubicSpline::fit(once, kind, true);
        const auto two = CubicSpline::fit(twice, kind, true);
        EXPECT_NEAR(two->length_m(), 2.0 * one->length_m(), 1e-13);
        for (const double t : {0.5, 9.25, 16.5, 31.0})
            EXPECT_LT((two->position_m(t) - one->position_m(t)).norm(), 1e-16);
    }
}

TEST(CubicSplineStability, aMillionRandomPointsAreInterpolatedToRounding) {
    std::mt19937_64 engine(12);
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
    Points points(1'000'000);
    for (Point& p : points)
        p = {coordinate(engine), coordinate(engine)};
    for (const bool closed : {false, true}) {
        const auto spline = CubicSpline::fit(points, SplineKind::interpolating, closed);
        double worst_m = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i)
            worst_m = std::max(worst_m, (spline->position_m(static_cast<double>(i)) - points[i]).norm());
        EXPECT_LT(worst_m, 1e-14);
    }
}

TEST(CubicSplineStability, parametersThatAreNotFiniteHaveADefinedPlace) {
    for (const bool closed : {false, true}) {
        const auto spline = CubicSpline::fit(circlePoints(8), SplineKind::interpolating, closed);
        EXPECT_EQ(spline->position_m(kNaN), spline->position_m(0.0));
        EXPECT_EQ(spline->position_m(-kInfinity), spline->position_m(0.0));
        EXPECT_EQ(spline->position_m(kInfinity), spline->position_m(closed ? 0.0 : 7.0));
    }
}

} // namespace teleta::contour
