// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/undistortion.h"
#include "tests/backend/vision/test_cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace teleta::vision {
namespace {

CameraParameters weakLens() {
    CameraParameters camera;
    camera.width_px = 640;
    camera.height_px = 480;
    camera.fx_px = 500.0;
    camera.fy_px = 490.0;
    camera.cx_px = 321.0;
    camera.cy_px = 238.0;
    camera.distortion.k1 = -0.2;
    camera.distortion.p1 = 1e-3;
    return camera;
}

/// Pixel of a point at unit distance, by the formula of the lens written out.
Eigen::Vector2d pixelOf(const CameraParameters& camera, const Eigen::Vector2d& point) {
    const auto& d = camera.distortion;
    const double x = point.x(), y = point.y(), s = x * x + y * y;
    const double q = (1.0 + d.k1 * s + d.k2 * s * s + d.k3 * s * s * s) /
                     (1.0 + d.k4 * s + d.k5 * s * s + d.k6 * s * s * s);
    const double xd = q * x + 2.0 * d.p1 * x * y + d.p2 * (s + 2.0 * x * x);
    const double yd = q * y + d.p1 * (s + 2.0 * y * y) + 2.0 * d.p2 * x * y;
    return {camera.fx_px * xd + camera.skew_px * yd + camera.cx_px, camera.fy_px * yd + camera.cy_px};
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace

TEST(UndistortByIteration, withoutDistortionIsExactWithAnyNumberOfSteps) {
    CameraParameters camera = weakLens();
    camera.distortion = {};
    camera.skew_px = 3.0;
    const Eigen::Vector2d point(0.2, -0.1);
    for (const int steps : {0, 1, 20})
        EXPECT_LT((*undistortByIteration(camera, pixelOf(camera, point), steps) - point).norm(), 1e-15);
}

TEST(UndistortByIteration, comesNearerWithEveryStepOfAWeakLens) {
    const Eigen::Vector2d point(0.3, -0.2);
    const Eigen::Vector2d pixel = pixelOf(weakLens(), point);
    double last = std::numeric_limits<double>::infinity();
    for (const int steps : {0, 1, 2, 5, 10}) {
        const double error = (*undistortByIteration(weakLens(), pixel, steps) - point).norm();
        EXPECT_LT(error, 0.5 * last) << steps;
        last = error;
    }
    EXPECT_LT((*undistortByIteration(weakLens(), pixel, 40) - point).norm(), 1e-12);
}

// With the radial map R(r) a step is r <- R(r*) r / R(r), whose slope at r* is 1 - r* R'(r*) / R(r*): about
// 0.63 at r = 2 of the wide lens, where the weak lens above has 0.1.
TEST(UndistortByIteration, isSlowAtTheRimOfAWideLens) {
    CameraParameters camera = paperCamera();
    camera.distortion.p1 = camera.distortion.p2 = 0.0;
    const Eigen::Vector2d point(2.0, 0.0);
    const Eigen::Vector2d pixel = pixelOf(camera, point);
    const auto error = [&](int steps) {
        return (*undistortByIteration(camera, pixel, steps) - point).norm();
    };
    const auto radial = [&](double r) { return pixelOf(camera, {r, 0.0}).x() - camera.cx_px; };
    const double slope = (radial(2.001) - radial(1.999)) / 0.002;
    EXPECT_NEAR(error(31) / error(30), 1.0 - 2.0 * slope / radial(2.0), 1e-4);
    EXPECT_GT(error(5), 0.01);
}

TEST(UndistortByIteration, isEmptyWithoutNumbers) {
    EXPECT_FALSE(undistortByIteration(weakLens(), {std::nan(""), 0.0}, 5));
    EXPECT_FALSE(undistortByIteration(weakLens(), {std::numeric_limits<double>::infinity(), 0.0}, 5));
    CameraParameters pole = weakLens();
    pole.distortion = {};
    pole.distortion.k1 = -1.0; // numerator 0 at r = 1
    EXPECT_FALSE(undistortByIteration(pole, {pole.cx_px + pole.fx_px, pole.cy_px}, 1));
}

TEST(DirectionTable, looksWhereThePixelLooksAndItsErrorFallsWithTheSquareOfTheStep) {
    const CameraModel camera = *CameraModel::create(paperCamera());
    double worst[2] = {0.0, 0.0};
    const DirectionTable coarse(camera, 32), fine(camera, 8);
    EXPECT_GT(fine.nodes(), 15 * coarse.nodes());
    for (double angle = 0.0; angle < 6.28; angle += 0.37)
        for (double r = 0.05; r < 1.9; r += 0.13) {
            const Eigen::Vector2d point(r * std::cos(angle), r * std::sin(angle));
            const Eigen::Vector2d pixel = pixelOf(paperCamera(), point);
            if (!camera.sees(pixel) || pixel.y() > 1200.0 || pixel.x() > 1600.0)
                continue;
            const Eigen::Vector3d truth(point.x(), point.y(), 1.0);
            ASSERT_TRUE(coarse.direction(pixel) && fine.direction(pixel));
            worst[0] = std::max(worst[0], angleBetween(*coarse.direction(pixel), truth));
            worst[1] = std::max(worst[1], angleBetween(*fine.direction(pixel), truth));
        }
    EXPECT_LT(worst[0], 1e-3);
    // (32 / 8)^2 = 16 for the worst place of a cell; the same pixels do not fall on the worst of both.
    EXPECT_LT(worst[1], worst[0] / 8.0);
    EXPECT_GT(worst[1], worst[0] / 64.0);
}

TEST(DirectionTable, isExactAtItsNodes) {
    const CameraModel camera = *CameraModel::create(paperCamera());
    const DirectionTable table(camera, 16);
    const Eigen::Vector2d pixel(48.0 * 16.0, 30.0 * 16.0);
    const Eigen::Vector2d point = *camera.undistort(pixel);
    EXPECT_LT((*table.direction(pixel) - Eigen::Vector3d(point.x(), point.y(), 1.0).normalized()).norm(),
              1e-14);
}

TEST(DirectionTable, hasNoneOutsideTheImageAndForNoNumber) {
    const CameraModel camera = *CameraModel::create(weakLens());
    const DirectionTable table(camera, 16);
    EXPECT_TRUE(table.direction({0.0, 0.0}));
    EXPECT_FALSE(table.direction({-0.01, 10.0}));
    EXPECT_FALSE(table.direction({10.0, 500.0}));
    EXPECT_FALSE(table.direction({std::nan(""), 10.0}));
}

} // namespace teleta::vision
