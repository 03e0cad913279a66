// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/vision/test_cameras.h"

#include <gtest/gtest.h>

#include <limits>

#ifdef TELETA_HAS_OPENCV
#include <opencv2/calib3d.hpp>
#endif

namespace teleta::vision {
namespace {

RationalDistortion someLens() {
    return {0.41, -0.13, 0.021, 0.63, 0.08, 0.007, 0.002, -0.003};
}

TEST(RationalDistortion, agreesWithTheFormulaOfThePaper) {
    const RationalDistortion lens = someLens();
    const double x = 0.7;
    const double y = -0.4;
    const double s = 0.65;
    const double q = (1.0 + 0.41 * s - 0.13 * s * s + 0.021 * s * s * s) /
                     (1.0 + 0.63 * s + 0.08 * s * s + 0.007 * s * s * s);
    const Eigen::Vector2d seen = lens.apply({x, y});
    EXPECT_NEAR(seen.x(), x * q + 2.0 * 0.002 * x * y - 0.003 * (s + 2.0 * x * x), 1e-15);
    EXPECT_NEAR(seen.y(), y * q + 0.002 * (s + 2.0 * y * y) - 2.0 * 0.003 * x * y, 1e-15);
}

TEST(RationalDistortion, aContinuedFractionOfTheArcTangentIsAnEquidistantLens) {
    const RationalDistortion lens = fractionLens(kEquidistant);
    for (const double r : {0.1, 0.5, 1.0, 1.5})
        EXPECT_NEAR(lens.radial(r), std::atan(r), 2e-4 * r) << r;
}

TEST(RationalDistortion, derivativesAgreeWithDifferences) {
    const RationalDistortion lens = someLens();
    constexpr double kStep = 1e-6;
    for (const Eigen::Vector2d& point : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.7, -0.4),
                                         Eigen::Vector2d(-1.3, 0.2), Eigen::Vector2d(0.0, 2.0)}) {
        Eigen::Matrix2d slope;
        for (int i = 0; i < 2; ++i) {
            const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(i);
            slope.col(i) = (lens.apply(point + step) - lens.apply(point - step)) / (2.0 * kStep);
        }
        EXPECT_LT((lens.slope(point) - slope).norm(), 1e-8);
        const double r = point.norm();
        EXPECT_NEAR(lens.radialSlope(r), (lens.radial(r + kStep) - lens.radial(r - kStep)) / (2.0 * kStep),
                    1e-8);
    }
}

TEST(RationalDistortion, withoutDecentringTheValidRadiusEndsWhereTheRadialMapTurns) {
    RationalDistortion lens;
    lens.k1 = -0.1; // r - 0.1 r^3 turns at r^2 = 1/0.3, where its slope is the least one asked for
    EXPECT_NEAR(monotoneRadius(lens, 10.0), std::sqrt((1.0 - kLeastSlope) / 0.3), 1e-9);
    EXPECT_EQ(monotoneRadius(lens, 1.0), 1.0);
    EXPECT_EQ(monotoneRadius({}, 11.0), 11.0);
}

TEST(RationalDistortion, aPoleEndsTheValidRadius) {
    RationalDistortion lens;
    lens.k4 = -0.25; // denominator zero at r = 2
    const double radius = monotoneRadius(lens, 10.0);
    EXPECT_LT(radius, 2.0);
    EXPECT_GT(radius, 1.99);
}

TEST(RationalDistortion, aNarrowFoldIsFound) {
    // Numerator and denominator nearly cancel at r = 1 but for a fold 1e-4 wide.
    RationalDistortion lens;
    lens.k4 = -2.0;
    lens.k5 = 1.0 + 1e-10; // (1 - s)^2 + 1e-10 s^2
    lens.k1 = -2.0;
    lens.k2 = 1.0 + 3e-10;
    const double radius = monotoneRadius(lens, 5.0);
    EXPECT_LT(radius, 1.0001);
    EXPECT_GT(radius, 0.99);
}

TEST(RationalDistortion, withinTheValidRadiusNoTwoPointsComeTogether) {
    CameraLottery lottery(3);
    for (int trial = 0; trial < 2000; ++trial) {
        RationalDistortion lens;
        for (double* k : {&lens.k1, &lens.k2, &lens.k3, &lens.k4, &lens.k5, &lens.k6})
            *k = lottery.uniform(-0.5, 0.5);
        lens.p1 = lottery.uniform(-0.05, 0.05);
        lens.p2 = lottery.uniform(-0.05, 0.05);
        const double radius = monotoneRadius(lens, 3.0);
        ASSERT_GT(radius, 0.0);
        for (int pair = 0; pair < 20; ++pair) {
            const auto point = [&] {
                const double angle = lottery.uniform(0.0, 2.0 * std::numbers::pi);
                return Eigen::Vector2d(radius * std::sqrt(lottery.uniform(0.0, 1.0)) *
                                       Eigen::Vector2d(std::cos(angle), std::sin(angle)));
            };
            const Eigen::Vector2d a = point();
            const Eigen::Vector2d b = point();
            // What a positive definite derivative means for any two points of a convex set.
            EXPECT_GE((lens.apply(a) - lens.apply(b)).dot(a - b), 0.99 * kLeastSlope * (a - b).squaredNorm());
        }
    }
}

TEST(RationalDistortion, aParameterThatIsNoNumberHasNoValidRadius) {
    RationalDistortion lens;
    lens.k3 = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(monotoneRadius(lens, 3.0), 0.0);
    lens.k3 = std::numeric_limits<double>::infinity();
    EXPECT_EQ(monotoneRadius(lens, 3.0), 0.0);
    EXPECT_EQ(monotoneRadius({}, 0.0), 0.0);
    EXPECT_EQ(monotoneRadius({}, std::numeric_limits<double>::quiet_NaN()), 0.0);
}

#ifdef TELETA_HAS_OPENCV
TEST(RationalDistortion, projectsAsOpenCvDoes) {
    CameraLottery lottery(7);
    for (int trial = 0; trial < 50; ++trial) {
        CameraParameters parameters = lottery.camera();
        parameters.mirrored = false;
        const auto camera = CameraModel::create(parameters);
        ASSERT_TRUE(camera);
        cv::Matx33d r;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                r(i, j) = parameters.R_Camera_Sensor(i, j);
        }
        cv::Vec3d turn;
        cv::Rodrigues(r, turn);
        const Eigen::Vector3d t = -parameters.R_Camera_Sensor * parameters.p_Sensor_Camera_m;
        const RationalDistortion& k = parameters.distortion;
        const std::vector<double> lens{k.k1, k.k2, k.p1, k.p2, k.k3, k.k4, k.k5, k.k6};
        const cv::Matx33d focus(parameters.fx_px, 0, parameters.cx_px, 0, parameters.fy_px, parameters.cy_px,
                                0, 0, 1);
        for (int i = 0; i < 20; ++i) {
            const Eigen::Vector3d p = onCylinder(lottery.uniform(-3.0, 3.0), lottery.uniform(0.0, 0.1));
            std::vector<cv::Point2d> seen;
            cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, turn,
                              cv::Vec3d(t.x(), t.y(), t.z()), focus, lens, seen);
            const auto pixel = camera->project(p);
            ASSERT_TRUE(pixel);
            EXPECT_NEAR(pixel->x(), seen[0].x, 1e-9);
            EXPECT_NEAR(pixel->y(), seen[0].y, 1e-9);
        }
    }
}
#else
TEST(RationalDistortion, projectsAsOpenCvDoes) {
    GTEST_SKIP() << "OpenCV is not here";
}
#endif

} // namespace
} // namespace teleta::vision
