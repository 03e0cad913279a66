// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/vision/test_cameras.h"

#include <gtest/gtest.h>

#include <limits>

namespace teleta::vision {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

CameraModel camera(const CameraParameters& parameters) {
    const auto made = CameraModel::create(parameters);
    EXPECT_TRUE(made);
    return *made;
}

CameraParameters straight() {
    CameraParameters parameters;
    parameters.fx_px = 500.0;
    parameters.fy_px = 400.0;
    parameters.cx_px = 800.0;
    parameters.cy_px = 600.0;
    parameters.p_Sensor_Camera_m = {0.0, 0.0, -0.02};
    return parameters;
}

TEST(CameraModel, withoutDistortionIsThePerspectiveOfTheTextbook) {
    const auto pixel = camera(straight()).project({0.01, 0.02, 0.08});
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), 800.0 + 500.0 * 0.1, 1e-12);
    EXPECT_NEAR(pixel->y(), 600.0 + 400.0 * 0.2, 1e-12);
}

TEST(CameraModel, skewShearsTheImage) {
    CameraParameters parameters = straight();
    parameters.skew_px = 10.0;
    const auto pixel = camera(parameters).project({0.01, 0.02, 0.08});
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), 800.0 + 500.0 * 0.1 + 10.0 * 0.2, 1e-12);
}

TEST(CameraModel, aMirroredFrameHasItsYFlipped) {
    CameraParameters parameters = straight();
    parameters.mirrored = true;
    const auto pixel = camera(parameters).project({0.01, 0.02, 0.08});
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), 850.0, 1e-12);
    EXPECT_NEAR(pixel->y(), 600.0 - 400.0 * 0.2, 1e-12);
    EXPECT_NEAR(parameters.linearPart().determinant(), -1.0, 1e-15);
}

TEST(CameraModel, theCentreIsThatOfTheSensorFrame) {
    // The erratum of eq. (3): a point on the optical axis through C is seen at the principal point.
    CameraParameters parameters = paperCamera();
    const Eigen::Vector3d axis = parameters.linearPart().row(2).transpose();
    const auto pixel = camera(parameters).project(parameters.p_Sensor_Camera_m + 0.05 * axis);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), parameters.cx_px, 1e-10);
    EXPECT_NEAR(pixel->y(), parameters.cy_px, 1e-10);
}

TEST(CameraModel, aRayPassesThroughThePointThatWasProjected) {
    CameraLottery lottery(11);
    for (int trial = 0; trial < 200; ++trial) {
        const CameraModel model = camera(lottery.camera());
        for (int i = 0; i < 20; ++i) {
            const Eigen::Vector3d p = onCylinder(lottery.uniform(-3.0, 3.0), lottery.uniform(0.0, 0.1));
            const auto pixel = model.project(p);
            ASSERT_TRUE(pixel);
            const auto direction = model.ray(*pixel);
            ASSERT_TRUE(direction);
            EXPECT_NEAR(direction->norm(), 1.0, 1e-14);
            EXPECT_LT(direction->cross(p - model.centre_m()).norm(), 1e-14);
            EXPECT_GT(direction->dot(p - model.centre_m()), 0.0);
        }
    }
}

TEST(CameraModel, everyPixelOfTheImageComesBackOrIsRefusedWithItsReason) {
    CameraLottery lottery(13);
    int seen = 0;
    int refused = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const CameraModel model = camera(lottery.camera());
        // The lenses hold over 65 degrees at least.
        const double needed_px = model.parameters().distortion.radial(2.1) *
                                 std::min(model.parameters().fx_px, model.parameters().fy_px);
        for (int i = 0; i < 500; ++i) {
            const Eigen::Vector2d pixel(lottery.uniform(-0.5, 1639.5), lottery.uniform(-0.5, 1231.5));
            const auto direction = model.ray(pixel);
            const Eigen::Vector2d centre(model.parameters().cx_px, model.parameters().cy_px);
            if (!direction) {
                EXPECT_EQ(direction.error(), ProjectionFailure::outsideValidRadius);
                EXPECT_GT((pixel - centre).norm(), 0.95 * needed_px);
                ++refused;
                continue;
            }
            ++seen;
            const auto back = model.project(model.centre_m() + 0.1 * *direction);
            ASSERT_TRUE(back) << toString(back.error());
            EXPECT_LT((*back - pixel).norm(), 1e-9);
        }
    }
    EXPECT_GT(seen, 50'000);
    EXPECT_GT(refused, 0);
}

TEST(CameraModel, derivativesAgreeWithDifferences) {
    const CameraParameters parameters = paperCamera();
    const CameraModel model = camera(parameters);
    const Eigen::Vector3d p = onCylinder(0.7, 0.02);
    const auto projection = model.projectWithDerivatives(p);
    ASSERT_TRUE(projection);

    constexpr double kStep = 1e-6;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d step = 1e-3 * kStep * Eigen::Vector3d::Unit(i);
        const Eigen::Vector2d slope = (*model.project(p + step) - *model.project(p - step)) / (2e-3 * kStep);
        EXPECT_LT((projection->byPoint.col(i) - slope).norm(), 1e-6 * projection->byPoint.norm());
    }
    const auto changed = [&](int parameter, double step) {
        CameraParameters c = parameters;
        double* const values[] = {&c.fx_px, &c.fy_px, &c.skew_px, &c.cx_px, &c.cy_px};
        double* const lens[] = {&c.distortion.k1, &c.distortion.k2, &c.distortion.k3, &c.distortion.k4,
                                &c.distortion.k5, &c.distortion.k6, &c.distortion.p1, &c.distortion.p2};
        if (parameter < 5)
            *values[parameter] += step;
        else if (parameter < 8)
            c.R_Camera_Sensor = rotation(step * Eigen::Vector3d::Unit(parameter - 5)) * c.R_Camera_Sensor;
        else if (parameter < 11)
            c.p_Sensor_Camera_m += step * Eigen::Vector3d::Unit(parameter - 8);
        else
            *lens[parameter - 11] += step;
        return *camera(c).project(p);
    };
    for (int i = 0; i < kCameraParameters; ++i) {
        const double step = i >= 8 && i < 11 ? 1e-3 * kStep : kStep;
        const Eigen::Vector2d slope = (changed(i, step) - changed(i, -step)) / (2.0 * step);
        EXPECT_LT((projection->byParameters.col(i) - slope).norm(), 1e-6 * (1.0 + slope.norm())) << i;
    }
}

TEST(CameraModel, pointsThatItCannotSeeHaveAReason) {
    const CameraModel model = camera(paperCamera());
    EXPECT_EQ(model.project({0.0, 0.0, -0.05}).error(), ProjectionFailure::behindCamera);
    EXPECT_EQ(model.project(model.centre_m()).error(), ProjectionFailure::behindCamera);
    EXPECT_EQ(model.project({0.025, 0.0, -0.02}).error(), ProjectionFailure::outsideValidRadius);
    EXPECT_EQ(model.project({kNan, 0.0, 0.05}).error(), ProjectionFailure::notFinite);
    EXPECT_EQ(model.project({0.0, kInfinity, 0.05}).error(), ProjectionFailure::notFinite);
    EXPECT_EQ(model.ray({kNan, 0.0}).error(), ProjectionFailure::notFinite);
    EXPECT_EQ(model.ray({1e6, 0.0}).error(), ProjectionFailure::outsideValidRadius);
    EXPECT_EQ(model.ray({1e300, 0.0}).error(), ProjectionFailure::notFinite);
}

TEST(CameraModel, parametersThatMakeNoCameraAreRefused) {
    const auto refusal = [](auto change) {
        CameraParameters parameters = paperCamera();
        change(parameters);
        return CameraModel::create(parameters).error();
    };
    using Refusal = CameraModel::Refusal;
    EXPECT_EQ(refusal([](auto& c) { c.fx_px = kNan; }), Refusal::notFinite);
    EXPECT_EQ(refusal([](auto& c) { c.distortion.k4 = kInfinity; }), Refusal::notFinite);
    EXPECT_EQ(refusal([](auto& c) { c.width_px = 0; }), Refusal::noImage);
    EXPECT_EQ(refusal([](auto& c) { c.fy_px = -700.0; }), Refusal::noFocus);
    EXPECT_EQ(refusal([](auto& c) { c.R_Camera_Sensor *= 1.1; }), Refusal::notRotation);
    EXPECT_EQ(refusal([](auto& c) { c.R_Camera_Sensor.col(0) *= -1.0; }), Refusal::notRotation);
}

TEST(CameraModel, theImageEndsHalfAPixelBeyondItsOutermostCentres) {
    const CameraModel model = camera(straight());
    EXPECT_TRUE(model.sees({-0.5, -0.5}));
    EXPECT_TRUE(model.sees({1639.4, 1231.4}));
    EXPECT_FALSE(model.sees({-0.6, 0.0}));
    EXPECT_FALSE(model.sees({0.0, 1231.5}));
    EXPECT_FALSE(model.sees({kNan, 0.0}));
}

} // namespace
} // namespace teleta::vision
