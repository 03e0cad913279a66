// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/vision/test_cameras.h"

#include <gtest/gtest.h>

#include <limits>

namespace teleta::vision {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

CylinderCamera paper(const CameraCovariance& covariance = CameraCovariance::Zero(), double noise_px = 0.0) {
    return {*CameraModel::create(paperCamera()), CylinderSurface{}, covariance, noise_px};
}

TEST(CylinderProjection, aRayFromTheAxisMeetsTheSurfaceWhereTheTriangleSays) {
    const CylinderSurface surface;
    const Eigen::Vector3d direction = Eigen::Vector3d(3.0, 0.0, 4.0).normalized();
    const auto distance_m = distanceToSurface_m(surface, {0.0, 0.0, 0.0}, direction);
    ASSERT_TRUE(distance_m);
    EXPECT_NEAR(*distance_m, 0.025 * 5.0 / 3.0, 1e-16);
}

TEST(CylinderProjection, fromOutsideTheNearWallIsSeenAndTheFarOneWhereTheNearOneEnds) {
    CylinderSurface surface;
    const Eigen::Vector3d direction = Eigen::Vector3d(-1.0, 0.0, 0.5).normalized();
    const auto near_m = distanceToSurface_m(surface, {0.05, 0.0, 0.0}, direction);
    ASSERT_TRUE(near_m);
    EXPECT_NEAR(*near_m * direction.x(), -0.025, 1e-16);
    surface.lowest_z_m = 0.02; // the near wall is met at z = 12.5 mm, the far one at 37.5 mm
    const auto far_m = distanceToSurface_m(surface, {0.05, 0.0, 0.0}, direction);
    ASSERT_TRUE(far_m);
    EXPECT_NEAR(*far_m * direction.x(), -0.075, 1e-16);
}

TEST(CylinderProjection, raysThatMeetNothingSayWhy) {
    const CylinderSurface surface;
    const auto reason = [&](const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction) {
        return distanceToSurface_m(surface, origin_m, direction.normalized()).error();
    };
    EXPECT_EQ(reason({0.0, 0.0, -0.02}, {0.0, 0.0, 1.0}), NoHit::alongAxis);
    EXPECT_EQ(reason({0.025, 0.0, -0.02}, {0.0, 0.0, 1.0}), NoHit::alongAxis);
    EXPECT_EQ(reason({0.025, -0.1, 0.0}, {0.0, 1.0, 0.0}), NoHit::tangent);
    EXPECT_EQ(reason({0.03, -0.1, 0.0}, {0.0, 1.0, 0.0}), NoHit::tangent);
    EXPECT_EQ(reason({0.05, 0.0, 0.05}, {1.0, 0.0, 0.0}), NoHit::behindCamera);
    EXPECT_EQ(reason({0.0, 0.0, -0.02}, {0.1, 0.0, 1.0}), NoHit::beyondEnds);
    EXPECT_EQ(reason({0.0, 0.0, -0.02}, {1.0, 0.0, -0.1}), NoHit::beyondEnds);
    EXPECT_EQ(distanceToSurface_m(surface, {kNan, 0.0, 0.0}, Eigen::Vector3d::UnitX()).error(),
              NoHit::notFinite);
}

TEST(CylinderProjection, everyPointOfTheSurfaceIsFoundAgain) {
    CameraLottery lottery(17);
    double worst_m = 0.0;
    for (int trial = 0; trial < 200; ++trial) {
        const CylinderCamera camera(*CameraModel::create(lottery.camera()), CylinderSurface{});
        for (int i = 0; i < 100; ++i) {
            const Eigen::Vector3d p = onCylinder(lottery.uniform(-3.2, 3.2), lottery.uniform(0.001, 0.099));
            const auto found_m = camera.locate_m(*camera.camera().project(p));
            ASSERT_TRUE(found_m) << toString(found_m.error());
            worst_m = std::max(worst_m, (*found_m - p).norm());
        }
    }
    EXPECT_LT(worst_m, 1e-12);
}

TEST(CylinderProjection, aPixelOutsideTheValidRadiusHasNoPoint) {
    EXPECT_EQ(paper().locate_m({1e5, 600.0}).error(), NoHit::outsideValidRadius);
    EXPECT_EQ(paper().locate_m({kNan, 600.0}).error(), NoHit::notFinite);
}

TEST(CylinderProjection, aVectorLiesOnTheTangentPlaneAndEndsOnTheRay) {
    const CylinderCamera camera = paper();
    CameraLottery lottery(19);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d p = onCylinder(lottery.uniform(-3.0, 3.0), lottery.uniform(0.01, 0.09));
        const Eigen::Vector3d around = Eigen::Vector3d(-p.y(), p.x(), 0.0).normalized();
        const Eigen::Vector3d moved =
            lottery.uniform(-2e-3, 2e-3) * around + lottery.uniform(-2e-3, 2e-3) * Eigen::Vector3d::UnitZ();
        const auto found_m =
            camera.tangentVector_m(*camera.camera().project(p), *camera.camera().project(p + moved));
        ASSERT_TRUE(found_m);
        EXPECT_LT((*found_m - moved).norm(), 1e-12);
    }
}

TEST(CylinderProjection, aVectorWhoseEndNeverMeetsThePlaneHasAReason) {
    // Away from the tangent plane, through the middle of the opposite wall.
    const CylinderCamera camera = paper();
    const Eigen::Vector2d from = *camera.camera().project(onCylinder(0.0, 0.02));
    const Eigen::Vector2d to = *camera.camera().project(onCylinder(std::numbers::pi, 0.02));
    EXPECT_EQ(camera.tangentVector_m(from, to).error(), NoHit::behindCamera);
    EXPECT_EQ(camera.tangentVector_m({1e5, 0.0}, from).error(), NoHit::outsideValidRadius);
    EXPECT_EQ(camera.tangentVector_m(from, {1e5, 0.0}).error(), NoHit::outsideValidRadius);
}

TEST(CylinderProjection, theDeviationOfAPointIsThatOfManyNoisyPixels) {
    constexpr double kNoise_px = 0.3;
    const CylinderCamera camera = paper(CameraCovariance::Zero(), kNoise_px);
    CameraLottery lottery(23);
    for (const double z_m : {0.01, 0.05, 0.09}) {
        const Eigen::Vector3d p = onCylinder(0.4, z_m);
        const Eigen::Vector2d pixel = *camera.camera().project(p);
        constexpr int kSamples = 20'000;
        double squares = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const Eigen::Vector2d noise(lottery.normal(kNoise_px), lottery.normal(kNoise_px));
            squares += (*camera.locate_m(pixel + noise) - p).squaredNorm();
        }
        // A sample of so many knows its deviation to 0.5 %.
        EXPECT_NEAR(*camera.standardDeviation_m(p), std::sqrt(squares / kSamples),
                    0.02 * std::sqrt(squares / kSamples));
    }
}

TEST(CylinderProjection, theDeviationGrowsTowardTheFarEnd) {
    const CylinderCamera camera = paper(CameraCovariance::Zero(), 0.5);
    double before_m = 0.0;
    for (double z_m = 0.0; z_m <= 0.1; z_m += 0.01) {
        const double deviation_m = *camera.standardDeviation_m(onCylinder(1.0, z_m));
        EXPECT_GT(deviation_m, before_m);
        before_m = deviation_m;
    }
}

TEST(CylinderProjection, anUncertainCentreShiftsThePointsAsTheCentre) {
    // A camera that looks straight and whose depth alone is uncertain sees all points shifted along the axis.
    CameraParameters parameters = paperCamera();
    parameters.R_Camera_Sensor.setIdentity();
    CameraCovariance covariance = CameraCovariance::Zero();
    covariance(10, 10) = 1e-3 * 1e-3;
    const CylinderCamera camera(*CameraModel::create(parameters), CylinderSurface{}, covariance, 0.0);
    for (const double z_m : {0.01, 0.05, 0.09}) {
        const Eigen::Matrix3d spread = *camera.covariance_m2(onCylinder(0.4, z_m));
        EXPECT_NEAR(spread(2, 2), 1e-6, 1e-15);
        EXPECT_NEAR(spread.trace(), 1e-6, 1e-15);
    }
}

TEST(CylinderProjection, theSurfaceMustHaveALengthAndARadius) {
    EXPECT_TRUE(CylinderSurface{}.isUsable());
    EXPECT_FALSE((CylinderSurface{0.0, 0.0, 0.1}).isUsable());
    EXPECT_FALSE((CylinderSurface{0.025, 0.1, 0.1}).isUsable());
    EXPECT_FALSE((CylinderSurface{kNan, 0.0, 0.1}).isUsable());
}

} // namespace
} // namespace teleta::vision
