// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/vision/simulated_pairs.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <limits>

namespace teleta::vision {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<CalibrationPair> pairsOf(const std::vector<Eigen::Vector3d>& points, double noise_px = 0.0) {
    CameraLottery lottery(3);
    const CameraModel camera = *CameraModel::create(paperCamera());
    std::vector<CalibrationPair> pairs;
    for (const Eigen::Vector3d& p : points)
        pairs.push_back(
            {*camera.project(p) + Eigen::Vector2d(lottery.normal(1.0), lottery.normal(1.0)) * noise_px, p});
    return pairs;
}

std::vector<Eigen::Vector3d> ring(double z_m, int count = 30) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i)
        points.push_back(onCylinder(2.0 * std::numbers::pi * i / count, z_m));
    return points;
}

void expectRefusal(const std::vector<CalibrationPair>& pairs, CalibrationRefusal refusal) {
    for (const CalibrationMethod method : kCalibrationMethods) {
        const auto calibration = calibrate(pairs, {}, method);
        ASSERT_FALSE(calibration) << toString(method);
        EXPECT_STREQ(toString(calibration.error()), toString(refusal)) << toString(method);
    }
}

TEST(CameraCalibrationStability, degeneratePairsAreRefusedWithTheirReason) {
    expectRefusal({}, CalibrationRefusal::tooFewPairs);
    std::vector<CalibrationPair> five = pairsOf(ring(0.02, 5));
    expectRefusal(five, CalibrationRefusal::tooFewPairs);
    std::vector<CalibrationPair> repeated;
    for (int i = 0; i < 20; ++i)
        repeated.insert(repeated.end(), five.begin(), five.end());
    expectRefusal(repeated, CalibrationRefusal::repeatedPoints);

    std::vector<Eigen::Vector3d> line;
    for (int i = 0; i < 30; ++i)
        line.push_back(onCylinder(0.7, 0.003 * i));
    expectRefusal(pairsOf(line), CalibrationRefusal::onOneLine);
    expectRefusal(pairsOf(ring(0.03)), CalibrationRefusal::onOneRing);

    // An oblique cut through the cylinder, and two lines of it.
    std::vector<Eigen::Vector3d> cut = ring(0.05);
    for (Eigen::Vector3d& p : cut)
        p.z() += p.x();
    expectRefusal(pairsOf(cut), CalibrationRefusal::inOnePlane);
    for (int i = 0; i < 30; ++i)
        line.push_back(onCylinder(2.1, 0.003 * i));
    expectRefusal(pairsOf(line), CalibrationRefusal::inOnePlane);
}

TEST(CameraCalibrationStability, numbersThatAreNoneAreRefused) {
    const teleta::test::WithoutFloatingPointTraps noNumbers;
    CameraLottery lottery(5);
    for (const double bad : {kNan, std::numeric_limits<double>::infinity(), 1e200}) {
        SimulatedPairs simulated = simulatePairs(paperCamera(), {}, lottery);
        simulated.pairs[17].p_Sensor_m.y() = bad;
        expectRefusal(simulated.pairs, CalibrationRefusal::notFinite);
        simulated = simulatePairs(paperCamera(), {}, lottery);
        simulated.pairs[17].pixel.x() = bad;
        expectRefusal(simulated.pairs, CalibrationRefusal::notFinite);
    }
    const SimulatedPairs simulated = simulatePairs(paperCamera(), {}, lottery);
    CalibrationSettings settings;
    settings.surface.radius_m = 0.0;
    EXPECT_EQ(calibrate(simulated.pairs, settings, CalibrationMethod::robust).error(),
              CalibrationRefusal::badSettings);
    // A camera whose file cannot be read is not used.
    for (const int side_px : {0, -1, kLargestSide_px + 1}) {
        settings = {};
        settings.width_px = side_px;
        EXPECT_EQ(calibrate(simulated.pairs, settings, CalibrationMethod::robust).error(),
                  CalibrationRefusal::badSettings);
        settings = {};
        settings.height_px = side_px;
        EXPECT_EQ(calibrate(simulated.pairs, settings, CalibrationMethod::robust).error(),
                  CalibrationRefusal::badSettings);
    }
}

TEST(CameraCalibrationStability, aRingThatThickensIsRefusedUntilItShowsTheCamera) {
    // Two rings that move apart over eight decades: refused, or correct within the stated uncertainty.
    bool accepted = false;
    for (double apart_m = 1e-9; apart_m <= 0.09; apart_m *= 10.0) {
        std::vector<Eigen::Vector3d> points = ring(0.005);
        const std::vector<Eigen::Vector3d> other = ring(0.005 + apart_m);
        points.insert(points.end(), other.begin(), other.end());
        const auto calibration = calibrate(pairsOf(points, 0.5), {}, CalibrationMethod::robust);
        if (!calibration) {
            EXPECT_FALSE(accepted) << apart_m;
            continue;
        }
        accepted = true;
        EXPECT_LT(surfaceErrors(paperCamera(), calibration->camera).mean_m(),
                  3.0 * calibration->uncertainty_m)
            << apart_m;
    }
}

TEST(CameraCalibrationStability, pixelsThatBelongToOtherPointsAreNoCamera) {
    CameraLottery lottery(7);
    SimulatedPairs simulated = simulatePairs(paperCamera(), {0.5, 0.0}, lottery);
    std::vector<Eigen::Vector2d> pixels;
    for (const CalibrationPair& pair : simulated.pairs)
        pixels.push_back(pair.pixel);
    std::shuffle(pixels.begin(), pixels.end(), lottery.engine());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        simulated.pairs[i].pixel = pixels[i];
    EXPECT_FALSE(calibrate(simulated.pairs, {}, CalibrationMethod::robust));
}

TEST(CameraCalibrationStability, theUnitOfPixelsDoesNotMatter) {
    // Images scaled from 1/8 to 8 times: the same camera in other pixels.
    CameraLottery lottery(11);
    const SimulatedPairs simulated = simulatePairs(paperCamera(), {0.5, 0.2}, lottery);
    const auto full = calibrate(simulated.pairs, {}, CalibrationMethod::robust);
    ASSERT_TRUE(full);
    for (const double scale : {0.125, 0.5, 8.0}) {
        std::vector<CalibrationPair> scaled = simulated.pairs;
        for (CalibrationPair& pair : scaled)
            pair.pixel *= scale;
        CalibrationSettings settings;
        settings.width_px = static_cast<int>(1640 * scale);
        settings.height_px = static_cast<int>(1232 * scale);
        const auto calibration = calibrate(scaled, settings, CalibrationMethod::robust);
        ASSERT_TRUE(calibration) << scale;
        EXPECT_EQ(calibration->kept, full->kept) << scale;
        EXPECT_NEAR(calibration->rms_px, scale * full->rms_px, 1e-3 * scale * full->rms_px) << scale;
    }
}

TEST(CameraModelStability, raysNearTheEdgeOfTheValidCircleComeBackOrAreRefused) {
    CameraLottery lottery(13);
    for (int trial = 0; trial < 20; ++trial) {
        CameraParameters parameters = lottery.camera();
        parameters.distortion.k1 -= 0.3 * lottery.uniform(0.0, 1.0); // folds earlier
        const auto camera = CameraModel::create(parameters);
        if (!camera)
            continue;
        const double edge = camera->validRadius();
        for (double beyond = 1e-14; beyond < 0.1; beyond *= 10.0) {
            for (const double r : {edge * (1.0 - beyond), edge * (1.0 + beyond)}) {
                const Eigen::Vector2d distorted = parameters.distortion.apply({r, 0.0});
                const Eigen::Vector2d pixel(parameters.fx_px * distorted.x() + parameters.cx_px,
                                            parameters.fy_px * distorted.y() + parameters.cy_px);
                const auto direction = camera->ray(pixel);
                if (!direction) {
                    EXPECT_GT(r, edge * (1.0 - 1e-9));
                    continue;
                }
                const auto back = camera->project(camera->centre_m() + *direction);
                ASSERT_TRUE(back);
                EXPECT_LT((*back - pixel).norm(), 1e-9);
            }
        }
    }
}

TEST(CylinderProjectionStability, raysThatApproachTheAxisLeaveThroughTheEnd) {
    const CylinderSurface surface;
    for (double tilt = 0.03; tilt > 1e-15; tilt /= 10.0) {
        const auto distance_m =
            distanceToSurface_m(surface, {0.0, 0.0, -0.02}, Eigen::Vector3d(tilt, 0.0, 1.0).normalized());
        ASSERT_FALSE(distance_m) << tilt;
        EXPECT_EQ(distance_m.error(), tilt > 1e-12 ? NoHit::beyondEnds : NoHit::alongAxis) << tilt;
    }
}

TEST(CylinderProjectionStability, raysThatApproachTheTangentKeepHalfTheDigits) {
    // The chord of a ray that passes the axis at rho (1 - e) has the half length rho sqrt(2 e - e^2).
    const CylinderSurface surface{1.0, -1.0, 1.0};
    for (double e = 0.1; e > 1e-13; e /= 10.0) {
        const double offset = 1.0 - e;
        const auto distance = distanceToSurface_m(surface, {-5.0, offset, 0.0}, {1.0, 0.0, 0.0});
        ASSERT_TRUE(distance) << e;
        const double exact = 5.0 - std::sqrt((1.0 - offset) * (1.0 + offset));
        EXPECT_NEAR(*distance, exact, 1e-15 * (10.0 + 1.0 / std::sqrt(e))) << e;
    }
    EXPECT_EQ(distanceToSurface_m(surface, {-5.0, 1.0, 0.0}, {1.0, 0.0, 0.0}).error(), NoHit::tangent);
    EXPECT_EQ(distanceToSurface_m(surface, {-5.0, 1.0 + 1e-12, 0.0}, {1.0, 0.0, 0.0}).error(),
              NoHit::tangent);
}

TEST(CylinderProjectionStability, aCameraThatTouchesTheWallSeesTheOtherSide) {
    // From near the wall both roots nearly cancel in the textbook formula.
    const CylinderSurface surface{1.0, -1.0, 1.0};
    for (double gap = 0.1; gap > 1e-15; gap /= 10.0) {
        const auto distance = distanceToSurface_m(surface, {1.0 - gap, 0.0, 0.0}, {1.0, 0.0, 0.0});
        ASSERT_TRUE(distance) << gap;
        const double exact = 1.0 - (1.0 - gap);
        EXPECT_NEAR(*distance / exact, 1.0, 1e-14) << gap;
    }
}

TEST(CylinderProjectionStability, lengthsScaleOver24Decades) {
    const Eigen::Vector3d direction = Eigen::Vector3d(0.6, 0.3, 0.5).normalized();
    const double one = *distanceToSurface_m({1.0, -1.0, 3.0}, {0.1, -0.2, 0.0}, direction);
    for (double scale = 1e-12; scale < 1e13; scale *= 10.0) {
        const auto distance = distanceToSurface_m({scale, -scale, 3.0 * scale},
                                                  Eigen::Vector3d(0.1, -0.2, 0.0) * scale, direction);
        ASSERT_TRUE(distance) << scale;
        EXPECT_NEAR(*distance / scale, one, 1e-14) << scale;
    }
}

} // namespace
} // namespace teleta::vision
