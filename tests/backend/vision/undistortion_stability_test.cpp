// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/undistortion.h"
#include "tests/backend/vision/test_cameras.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace teleta::vision {

namespace {

using Eigen::Vector2d;

/// A wide lens with its axis at pixel (0, 0), so that a small pixel has all its digits.
CameraParameters centred(const RationalDistortion& distortion) {
    CameraParameters camera;
    camera.cx_px = camera.cy_px = 0.0;
    camera.distortion = distortion;
    return camera;
}

CameraModel modelOf(const CameraParameters& parameters) {
    const auto model = CameraModel::create(parameters);
    EXPECT_TRUE(model);
    return *model;
}

} // namespace

TEST(UndistortionStability, aRayThatApproachesTheAxisOverTwelveDecadesComesBack) {
    const CameraParameters parameters = centred(fractionLens(kEquidistant));
    const CameraModel camera = modelOf(parameters);
    for (double r = 2.0; r > 1e-13; r /= 10.0) {
        const Vector2d point = r * Vector2d(0.6, -0.8);
        const Vector2d pixel = parameters.fx_px * parameters.distortion.apply(point);
        const auto back = camera.undistort(pixel);
        ASSERT_TRUE(back);
        // The radial map is hardly flatter than 1/5 within 63 degrees.
        const double allowed = 5.0 * CameraModel::kRoundTrip_px / parameters.fx_px;
        EXPECT_LE((*back - point).norm(), allowed) << r;
    }
    EXPECT_EQ(camera.undistort(Vector2d::Zero())->norm(), 0.0);
}

TEST(UndistortionStability, aLensThatFlattensOverTwelveDecadesBecomesAPinhole) {
    const Vector2d pixel(210.0, -140.0);
    const Vector2d pinhole = pixel / 700.0;
    const double r = pinhole.norm();
    for (double k = 0.1; k > 1e-13; k /= 10.0)
        for (const double sign : {-1.0, 1.0}) {
            RationalDistortion weak;
            weak.k1 = sign * k;
            const auto back = modelOf(centred(weak)).undistort(pixel);
            ASSERT_TRUE(back);
            // x'' = x (1 + k1 r^2): the first order, and less than the square of it as the rest.
            const Vector2d first = pinhole * (1.0 - weak.k1 * r * r);
            EXPECT_LE((*back - first).norm(), 4.0 * k * k * r * r * r * r * r + 1e-12) << weak.k1;
        }
    EXPECT_LE((*modelOf(centred({})).undistort(pixel) - pinhole).norm(), 1e-15);
}

TEST(UndistortionStability, withoutDecentringTurnsWithThePixel) {
    const CameraParameters parameters = centred(fractionLens(kEquidistant));
    const CameraModel camera = modelOf(parameters);
    const Vector2d pixel(500.0, 120.0);
    const Vector2d plain = *camera.undistort(pixel);
    for (int i = 0; i < 360; ++i) {
        const Eigen::Rotation2Dd turn(i * std::numbers::pi / 180.0);
        EXPECT_LE((*camera.undistort(turn * pixel) - turn * plain).norm(), 1e-11);
        const auto slow = undistortByIteration(parameters, turn * pixel, 20);
        ASSERT_TRUE(slow);
        EXPECT_LE((*slow - turn * *undistortByIteration(parameters, pixel, 20)).norm(), 1e-13);
    }
}

TEST(UndistortionStability, theUnitOfPixelsDoesNotMatter) {
    const CameraParameters parameters = centred(fractionLens(kEquidistant));
    const Vector2d pixel(-420.0, 333.0);
    const Vector2d plain = *modelOf(parameters).undistort(pixel);
    for (double factor = 1e-6; factor < 2e6; factor *= 10.0) {
        CameraParameters scaled = parameters;
        scaled.fx_px *= factor;
        scaled.fy_px *= factor;
        const auto back = modelOf(scaled).undistort(factor * pixel);
        ASSERT_TRUE(back) << factor;
        EXPECT_LE((*back - plain).norm(), 5.0 * CameraModel::kRoundTrip_px / scaled.fx_px + 1e-12) << factor;
    }
}

TEST(UndistortionStability, pixelsThatAreNoneOrBeyondAllMeasureAreRefused) {
    const teleta::test::WithoutFloatingPointTraps noNumbers;
    const CameraParameters parameters = paperCamera();
    const CameraModel camera = modelOf(parameters);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double none : {nan, infinity, -infinity})
        for (const Vector2d& pixel : {Vector2d(none, 100.0), Vector2d(100.0, none), Vector2d(none, none)}) {
            EXPECT_FALSE(camera.undistort(pixel));
            EXPECT_FALSE(camera.ray(pixel));
            for (const int iterations : {1, 20, 1000})
                EXPECT_FALSE(undistortByIteration(parameters, pixel, iterations));
        }
    for (const double far_px : {1e4, 1e8, 1e150, 1e300}) {
        EXPECT_FALSE(camera.undistort({far_px, -far_px})) << far_px;
        const auto stepped = undistortByIteration(parameters, {far_px, -far_px}, 50);
        EXPECT_TRUE(!stepped || stepped->array().isFinite().all()) << far_px;
    }
}

} // namespace teleta::vision
