// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/cubic_spline.h"
#include "tests/backend/contour/contour_points.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace teleta::contour {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Points randomPoints(std::size_t count, unsigned seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> coordinate(-0.1, 0.1);
    Points points(count);
    for (Point& p : points)
        p = {coordinate(engine), coordinate(engine)};
    return points;
}

/// Eq. (7) as printed, with the matrix.
Point printedSegment(const Point& a, const Point& b, const Point& c, const Point& d, double t) {
    Eigen::Matrix4d basis;
    basis << -1, 3, -3, 1, 3, -6, 3, 0, -3, 0, 3, 0, 1, 4, 1, 0;
    Eigen::Matrix<double, 4, 2> control;
    control << a.transpose(), b.transpose(), c.transpose(), d.transpose();
    return (Eigen::RowVector4d(t * t * t, t * t, t, 1.0) * basis * control / 6.0).transpose();
}

/// Largest |radius - 1| of the closed curve through or near points of the unit circle, in percent.
double circleDeviation_percent(SplineKind kind, std::size_t count) {
    const auto spline = CubicSpline::fit(circlePoints(count), kind, true);
    double worst = 0.0;
    for (int step = 0; step <= 100; ++step)
        worst = std::max(worst, std::abs(spline->position_m(0.01 * step).norm() - 1.0));
    return 100.0 * worst;
}

double midSegmentDeviation_percent(SplineKind kind, std::size_t count) {
    return 100.0 * std::abs(1.0 - CubicSpline::fit(circlePoints(count), kind, true)->position_m(0.5).norm());
}

/// Dense solve of the interpolation and end conditions without using their structure.
Points denseControl(const Points& points, bool closed) {
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 2, n + 2); // c_{-1} .. c_n
    Eigen::MatrixXd rightSide = Eigen::MatrixXd::Zero(n + 2, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
        system.row(i).segment(i, 3) << 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0;
        rightSide.row(i) = points[static_cast<std::size_t>(i)].transpose();
    }
    if (closed) {
        system(n, 0) = 1.0;
        system(n, n) = -1.0;
        system(n + 1, 1) = 1.0;
        system(n + 1, n + 1) = -1.0;
    } else {
        system.row(n).head(3) << 1.0, -2.0, 1.0;
        system.row(n + 1).tail(3) << 1.0, -2.0, 1.0;
    }
    const Eigen::MatrixXd solution = system.fullPivLu().solve(rightSide);
    Points control;
    for (Eigen::Index i = 0; i < n + 2; ++i)
        control.emplace_back(solution.row(i).transpose());
    if (closed)
        control.push_back(control[2]);
    return control;
}

} // namespace

TEST(CubicSpline, approximatingReproducesTheCircleDeviationsOfThePaper) {
    // TeleTA, Table 3.
    const std::pair<std::size_t, double> table[] = {{12, 4.49},  {16, 2.54}, {20, 1.63}, {24, 1.14},
                                                    {28, 0.836}, {32, 0.64}, {36, 0.51}};
    for (const auto& [count, percent] : table)
        EXPECT_NEAR(midSegmentDeviation_percent(SplineKind::approximating, count), percent, 0.01 * percent)
            << count;
}

TEST(CubicSpline, approximatingFollowsEquation10OfThePaper) {
    for (const std::size_t count : {4U, 8U, 12U, 36U, 360U}) {
        const double angle_rad = 2.0 * std::numbers::pi / static_cast<double>(count);
        const double c = std::cos(angle_rad);
        const Point expected((1.0 + c) * (11.0 + c) / 24.0, std::sin(angle_rad) * (11.0 + c) / 24.0);
        const auto spline = CubicSpline::fit(circlePoints(count), SplineKind::approximating, true);
        EXPECT_LT((spline->position_m(0.5) - expected).norm(), 8 * kEpsilon) << count;
    }
}

TEST(CubicSpline, interpolatingDeviatesFromACircleByThePublishedNumbers) {
    // From the closed form: the cyclic system scales the points of a circle by 3/(2 + cos(2 pi/m)).
    const auto closedForm_percent = [](double count) {
        const double angle_rad = 2.0 * std::numbers::pi / count;
        const double c = std::cos(angle_rad);
        return 100.0 * std::abs(1.0 - (11.0 + c) * std::cos(0.5 * angle_rad) / 12.0 * 3.0 / (2.0 + c));
    };
    for (const std::size_t count : {8U, 12U, 16U, 20U, 24U, 28U, 32U, 36U, 360U})
        EXPECT_NEAR(midSegmentDeviation_percent(SplineKind::interpolating, count),
                    closedForm_percent(static_cast<double>(count)), 1e-12)
            << count;
    EXPECT_NEAR(circleDeviation_percent(SplineKind::interpolating, 12), 0.02095, 0.000005);
    EXPECT_LT(circleDeviation_percent(SplineKind::interpolating, 12), 0.021);
    EXPECT_NEAR(circleDeviation_percent(SplineKind::interpolating, 36), 0.000243, 0.0000005);
}

TEST(CubicSpline, isEquation7AsPrintedOverTheRangeOfThePaper) {
    const Points points = randomPoints(9, 1);
    const auto spline = CubicSpline::fit(points, SplineKind::approximating, false);
    for (std::size_t i = 1; i + 2 < points.size(); ++i)
        for (const double t : {0.0, 0.3, 0.5, 0.99})
            EXPECT_LT((spline->position_m(static_cast<double>(i) + t) -
                       printedSegment(points[i - 1], points[i], points[i + 1], points[i + 2], t))
                          .norm(),
                      1e-15);
}

TEST(CubicSpline, interpolatingPassesThroughEveryPoint) {
    for (const bool closed : {false, true})
        for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 17U, 1000U}) {
            const Points points = randomPoints(count, static_cast<unsigned>(count));
            const auto spline = CubicSpline::fit(points, SplineKind::interpolating, closed);
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_LT((spline->position_m(static_cast<double>(i)) - points[i]).norm(), 1e-15)
                    << count << " points, closed " << closed << ", index " << i;
        }
}

TEST(CubicSpline, interpolatingEqualsADenseSolveOfItsConditions) {
    for (const bool closed : {false, true})
        for (const std::size_t count : {2U, 3U, 4U, 7U, 40U}) {
            const Points points = randomPoints(count, 100 + static_cast<unsigned>(count));
            const Points control = denseControl(points, closed);
            const auto spline = CubicSpline::fit(points, SplineKind::interpolating, closed);
            for (std::size_t segment = 0; segment < spline->segments(); ++segment)
                for (const double u : {0.1, 0.5, 0.8}) {
                    const Point expected =
                        printedSegment(control[segment], control[segment + 1], control[segment + 2],
                                       control[(segment + 3) % control.size()], u);
                    EXPECT_LT((spline->position_m(static_cast<double>(segment) + u) - expected).norm(), 1e-14)
                        << count << " points, closed " << closed << ", segment " << segment;
                }
        }
}

TEST(CubicSpline, openCurvesBeginAndEndInTheirEndPointsWithoutCurvature) {
    const Points points = randomPoints(6, 3);
    for (const auto kind : {SplineKind::approximating, SplineKind::interpolating}) {
        const auto spline = CubicSpline::fit(points, kind, false);
        ASSERT_EQ(spline->segments(), 5U);
        EXPECT_LT((spline->position_m(0.0) - points.front()).norm(), 1e-16);
        EXPECT_LT((spline->position_m(5.0) - points.back()).norm(), 1e-16);
        EXPECT_LT(spline->secondDerivative_m(0.0).norm(), 1e-15);
        EXPECT_LT(spline->secondDerivative_m(5.0).norm(), 1e-15);
        EXPECT_EQ(spline->curvature_perM(0.0), 0.0);
        EXPECT_EQ(spline->curvature_perM(5.0), 0.0);
    }
}

TEST(CubicSpline, isTwiceContinuouslyDifferentiableAtItsJoints) {
    const Points points = randomPoints(7, 4);
    constexpr double kStep = 1e-9;
    for (const bool closed : {false, true})
        for (const auto kind : {SplineKind::approximating, SplineKind::interpolating}) {
            const auto spline = CubicSpline::fit(points, kind, closed);
            for (int joint = closed ? 0 : 1; joint < 6; ++joint) {
                const double before = joint - kStep;
                const double after = joint + kStep;
                EXPECT_LT((spline->position_m(after) - spline->position_m(before)).norm(), 1e-8);
                EXPECT_LT((spline->derivative_m(after) - spline->derivative_m(before)).norm(), 1e-8);
                EXPECT_LT((spline->secondDerivative_m(after) - spline->secondDerivative_m(before)).norm(),
                          1e-8);
            }
        }
}

TEST(CubicSpline, derivativesAreThoseOfThePosition) {
    const auto spline = CubicSpline::fit(randomPoints(7, 5), SplineKind::interpolating, true);
    constexpr double kStep = 1e-4; // central differences are exact for the cubic up to its third derivative
    for (const double t : {0.5, 1.25, 3.7, 6.9}) {
        const Point first = (spline->position_m(t + kStep) - spline->position_m(t - kStep)) / (2.0 * kStep);
        const Point second =
            (spline->position_m(t + kStep) - 2.0 * spline->position_m(t) + spline->position_m(t - kStep)) /
            (kStep * kStep);
        EXPECT_LT((spline->derivative_m(t) - first).norm(), 1e-8);
        EXPECT_LT((spline->secondDerivative_m(t) - second).norm(), 1e-7);
    }
}

TEST(CubicSpline, curvatureOfACircleIsItsInverseRadiusWithTheSignOfTheDirection) {
    Points points = circlePoints(360, 0.05);
    const auto counterClockwise = CubicSpline::fit(points, SplineKind::interpolating, true);
    std::reverse(points.begin(), points.end());
    const auto clockwise = CubicSpline::fit(points, SplineKind::interpolating, true);
    for (const double t : {0.0, 0.25, 0.5, 17.3, 359.9}) {
        EXPECT_NEAR(counterClockwise->curvature_perM(t), 20.0, 0.001);
        EXPECT_NEAR(clockwise->curvature_perM(t), -20.0, 0.001);
    }
}

TEST(CubicSpline, curvatureIsEquation11OfItsDerivatives) {
    const auto spline = CubicSpline::fit(randomPoints(8, 6), SplineKind::interpolating, false);
    for (const double t : {0.4, 2.2, 5.5, 6.1}) {
        const Point d = spline->derivative_m(t);
        const Point dd = spline->secondDerivative_m(t);
        const double expected = (d.x() * dd.y() - d.y() * dd.x()) / std::pow(d.squaredNorm(), 1.5);
        EXPECT_NEAR(spline->curvature_perM(t), expected, 1e-12 * std::abs(expected));
    }
}

TEST(CubicSpline, lengthOfACircleApproachesItsCircumference) {
    // At 360 points the interpolating curve deviates from the circle by less than 3e-8 percent.
    const auto spline = CubicSpline::fit(circlePoints(360, 0.05), SplineKind::interpolating, true);
    EXPECT_NEAR(spline->length_m(), 2.0 * std::numbers::pi * 0.05, 1e-9 * 0.3);
}

TEST(CubicSpline, lengthOfAStraightLineIsTheDistanceOfItsEnds) {
    const Points points = {{0.01, 0.02}, {0.04, 0.06}, {0.07, 0.10}, {0.13, 0.18}};
    for (const auto kind : {SplineKind::approximating, SplineKind::interpolating})
        EXPECT_NEAR(CubicSpline::fit(points, kind, false)->length_m(), 0.2, 1e-12);
}

TEST(CubicSpline, parameterWrapsAroundAClosedCurveAndStopsAtTheEndsOfAnOpenOne) {
    const Points points = randomPoints(5, 7);
    const auto closed = CubicSpline::fit(points, SplineKind::interpolating, true);
    EXPECT_LT((closed->position_m(5.0) - points[0]).norm(), 1e-15);
    EXPECT_LT((closed->position_m(-1.0) - points[4]).norm(), 1e-15);
    EXPECT_LT((closed->position_m(12.5) - closed->position_m(2.5)).norm(), 1e-15);
    const auto open = CubicSpline::fit(points, SplineKind::interpolating, false);
    EXPECT_EQ(open->position_m(-3.0), open->position_m(0.0));
    EXPECT_EQ(open->position_m(9.0), open->position_m(4.0));
}

TEST(CubicSpline, collinearControlPointsGiveAStraightSegmentThatJoinsWithContinuousCurvature) {
    // TeleTA, section 3: four collinear control points between bends. Segments 2 and 3 have them.
    const Points points = {{0.0, 0.03}, {0.01, 0.0}, {0.02, 0.0},  {0.03, 0.0},
                           {0.04, 0.0}, {0.05, 0.0}, {0.07, -0.02}};
    const auto spline = CubicSpline::fit(points, SplineKind::approximating, false);
    for (const double t : {2.0, 2.4, 3.0, 3.6, 4.0}) {
        EXPECT_NEAR(spline->position_m(t).y(), 0.0, 4 * kEpsilon * 0.03) << t;
        EXPECT_EQ(spline->curvature_perM(t), 0.0) << t;
    }
    EXPECT_GT(spline->curvature_perM(1.9), 0.0);
    EXPECT_LT(spline->curvature_perM(4.1), 0.0);
    // Linear in the distance to the joint: continuous, and the straight piece ends where it should.
    EXPECT_NEAR(spline->curvature_perM(2.0 - 1e-6) / spline->curvature_perM(2.0 - 1e-7), 10.0, 1e-3);
    EXPECT_NEAR(spline->curvature_perM(4.0 + 1e-6) / spline->curvature_perM(4.0 + 1e-7), 10.0, 1e-3);
}

} // namespace teleta::contour
