// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/circle_fit.h"
#include "tests/backend/contour/contour_points.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace teleta::contour {
namespace {

Points arcPoints(std::size_t count, const Point& centre_m, double radius_m, double from_rad, double to_rad) {
    Points points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(centre_m +
                         onCircle(radius_m, from_rad + (to_rad - from_rad) * static_cast<double>(i) /
                                                           static_cast<double>(count - 1)));
    return points;
}

} // namespace

TEST(CircleFit, findsTheCircleThatItsPointsAreOn) {
    for (const double span_rad : {6.2, 3.0, 1.0, 0.5}) {
        const auto circle = fitCircle(arcPoints(20, {0.3, -0.1}, 0.05, 0.4, 0.4 + span_rad));
        ASSERT_TRUE(circle.has_value());
        EXPECT_LT((circle->centre_m - Point(0.3, -0.1)).norm(), 1e-12) << span_rad;
        EXPECT_NEAR(circle->radius_m, 0.05, 1e-12) << span_rad;
        EXPECT_LT(circle->rms_m, 1e-13);
    }
}

TEST(CircleFit, throughThreePointsIsTheirCircumscribedCircle) {
    // A right angle is inscribed in the circle over its hypotenuse.
    const auto circle = fitCircle(Points{{0.0, 0.0}, {0.06, 0.0}, {0.0, 0.08}});
    ASSERT_TRUE(circle.has_value());
    EXPECT_LT((circle->centre_m - Point(0.03, 0.04)).norm(), 1e-14);
    EXPECT_NEAR(circle->radius_m, 0.05, 1e-14);
}

TEST(CircleFit, minimisesDistancesNotAlgebraicResiduals) {
    // Two circles of points with one centre: the sum of (r_i - R)^2 is least at the mean radius, and the
    // deviation is half the difference. An algebraic fit finds the root mean square radius.
    Points points = circlePoints(16, 0.050);
    const Points outer = circlePoints(16, 0.051);
    points.insert(points.end(), outer.begin(), outer.end());
    const auto circle = fitCircle(points);
    ASSERT_TRUE(circle.has_value());
    EXPECT_LT(circle->centre_m.norm(), 1e-9);
    EXPECT_NEAR(circle->radius_m, 0.0505, 1e-8);
    EXPECT_NEAR(circle->rms_m, 0.0005, 1e-8);
}

TEST(CircleFit, isNotMovedByAnOutlier) {
    Points points = circlePoints(24, 0.05);
    points[7] += Point(0.04, -0.03);
    const auto circle = fitCircle(points);
    ASSERT_TRUE(circle.has_value());
    EXPECT_LT(circle->centre_m.norm(), 1e-9);
    EXPECT_NEAR(circle->radius_m, 0.05, 1e-9);
    EXPECT_LT(circle->rms_m, 1e-9);
}

TEST(CircleFit, hasTheAccuracyThatTheNoiseAllows) {
    // Full circle, n points, noise s: the radius has the standard error s/sqrt(n), the centre s sqrt(2/n) an
    // axis.
    constexpr std::size_t kCount = 40;
    constexpr double kNoise_m = 0.0005;
    constexpr int kRepeats = 400;
    std::mt19937_64 engine(21);
    std::normal_distribution<double> normal(0.0, kNoise_m);
    double radiusError2 = 0.0;
    double centreError2 = 0.0;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        Points points = circlePoints(kCount, 0.05);
        for (Point& p : points)
            p += Point(normal(engine), normal(engine));
        const auto circle = fitCircle(points);
        ASSERT_TRUE(circle.has_value());
        radiusError2 += std::pow(circle->radius_m - 0.05, 2) / kRepeats;
        centreError2 += circle->centre_m.squaredNorm() / kRepeats;
    }
    // The estimate over 400 repeats varies by 5 %, the biweight costs another 5 %.
    EXPECT_NEAR(std::sqrt(radiusError2), kNoise_m / std::sqrt(1.0 * kCount),
                0.2 * kNoise_m / std::sqrt(1.0 * kCount));
    EXPECT_NEAR(std::sqrt(centreError2), kNoise_m * std::sqrt(4.0 / kCount),
                0.2 * kNoise_m * std::sqrt(4.0 / kCount));
}

TEST(CircleFit, doesNotExistOnALineInOnePlaceOrForUnusablePoints) {
    EXPECT_FALSE(fitCircle({}).has_value());
    EXPECT_FALSE(fitCircle(Points{{1.0, 2.0}, {2.0, 1.0}}).has_value());
    EXPECT_FALSE(fitCircle(Points(6, Point(0.1, 0.2))).has_value());
    EXPECT_FALSE(fitCircle(Points{{0, 0}, {1, 1}, {2, 2}, {3, 3}}).has_value());
    EXPECT_FALSE(
        fitCircle(Points{{0, 0}, {1, 1}, {2, std::numeric_limits<double>::quiet_NaN()}}).has_value());
}

} // namespace teleta::contour
