// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/calibration_checks.h"
#include "backend/vision/calibration/camera_file.h"
#include "tests/backend/vision/simulated_pairs.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace teleta::vision {
namespace {

using Warnings = std::vector<CalibrationWarning>;

std::vector<CalibrationPair> somePairs(bool mirrored = true, unsigned seed = 83) {
    CameraLottery lottery(seed);
    CameraParameters truth = paperCamera();
    truth.mirrored = mirrored;
    return simulatePairs(truth, {0.4, 0.1}, lottery).pairs;
}

Calibration found(const std::vector<CalibrationPair>& pairs, const CalibrationSettings& settings = {},
                  CalibrationMethod method = CalibrationMethod::robust) {
    const auto calibration = calibrate(pairs, settings, method);
    EXPECT_TRUE(calibration) << toString(calibration.error());
    return *calibration;
}

std::vector<CalibrationPair> scaled(std::vector<CalibrationPair> pairs, double factor) {
    for (CalibrationPair& pair : pairs)
        pair.p_Sensor_m.head<2>() *= factor;
    return pairs;
}

std::vector<CalibrationPair> swapped(std::vector<CalibrationPair> pairs) {
    for (CalibrationPair& pair : pairs)
        std::swap(pair.pixel.x(), pair.pixel.y());
    return pairs;
}

TEST(CalibrationWarning, rightPairsHaveNone) {
    for (const bool mirrored : {false, true}) {
        const Calibration calibration = found(somePairs(mirrored));
        EXPECT_EQ(calibration.warnings, Warnings{});
        EXPECT_TRUE(calibration.isReliable());
        EXPECT_NEAR(calibration.surfaceFactor->value, 1.0, 1e-12);
    }
}

TEST(CalibrationWarning, aForgottenHoleFactorIsToldWithTheOneThatFits) {
    CameraLottery lottery(97);
    const std::vector<CalibrationPair> allRight =
        scaled(simulatePairs(paperCamera(), {0.4, 0.0}, lottery).pairs, 1.0 / 0.97);
    EXPECT_EQ(found(allRight, {}, CalibrationMethod::leastSquares).warnings,
              Warnings{CalibrationWarning::offSurface});
    const std::vector<CalibrationPair> holes = scaled(somePairs(), 1.0 / 0.97);
    const Calibration calibration = found(holes);
    EXPECT_EQ(calibration.warnings, Warnings{CalibrationWarning::offSurface});
    EXPECT_NEAR(calibration.surfaceFactor->value, 0.97, 1e-12);
    EXPECT_FALSE(calibration.isReliable());
    const std::string text = describe(CalibrationWarning::offSurface, calibration, 1.0).toStdString();
    for (const char* part : {"25.77 mm", "25 mm", "factor of 0.97 "})
        EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(CalibrationWarning, aHoleFactorForPointsThatAreOnTheSurfaceIsToldWithOne) {
    const Calibration calibration = found(scaled(somePairs(), 0.97));
    EXPECT_EQ(calibration.warnings, Warnings{CalibrationWarning::offSurface});
    const std::string text = describe(CalibrationWarning::offSurface, calibration, 0.97).toStdString();
    EXPECT_NE(text.find("factor of 1 "), std::string::npos) << text;
}

TEST(CalibrationWarning, aWrongRadiusIsToldToo) {
    CalibrationSettings settings;
    settings.surface.radius_m = 0.0255;
    EXPECT_EQ(found(somePairs(), settings).warnings, Warnings{CalibrationWarning::offSurface});
}

/// Normal errors of 0.1 mm: the median of n values has the standard error 1.2533 0.1 mm / sqrt(n).
TEST(CalibrationWarning, pointsThatWereMeasuredAreOnTheSurfaceWithinTheirScatter) {
    CameraLottery lottery(89);
    std::vector<CalibrationPair> pairs = somePairs();
    for (CalibrationPair& pair : pairs)
        pair.p_Sensor_m.head<2>() *= 1.0 + lottery.normal(0.004);
    const Calibration calibration = found(pairs);
    const double expected = 1.2533 * 0.004 / std::sqrt(static_cast<double>(calibration.kept));
    EXPECT_NEAR(calibration.surfaceFactor->standardError / expected, 1.0, 0.3);
    EXPECT_NEAR(calibration.surfaceFactor->value, 1.0, 4.0 * expected);
    EXPECT_EQ(std::ranges::count(calibration.warnings, CalibrationWarning::offSurface), 0);
}

TEST(CalibrationWarning, swappedPixelsAreToldForEitherHandedness) {
    for (const bool mirrored : {false, true}) {
        const Calibration calibration = found(swapped(somePairs(mirrored)));
        EXPECT_EQ(calibration.warnings, Warnings{CalibrationWarning::swappedPixels});
        // Pixels of a mirrored camera look like those of one that is not.
        EXPECT_EQ(calibration.camera.camera().parameters().mirrored, !mirrored);
        const OffMiddle off = offMiddle(calibration.camera.camera().parameters());
        EXPECT_NEAR(off.swapped_px, std::hypot(826.0 - 819.5, 609.0 - 615.5), 3.0);
        EXPECT_NEAR(off.fitted_px, std::hypot(609.0 - 819.5, 826.0 - 615.5), 3.0);
    }
}

TEST(CalibrationWarning, swappedWidthAndHeightLookTheSame) {
    CalibrationSettings settings;
    std::swap(settings.width_px, settings.height_px);
    EXPECT_EQ(found(somePairs(), settings).warnings, Warnings{CalibrationWarning::swappedPixels});
    EXPECT_EQ(found(swapped(somePairs()), settings).warnings, Warnings{});
}

TEST(CalibrationWarning, aSquareImageGivesNoEvidenceOfSwappedPixels) {
    CalibrationSettings settings;
    settings.width_px = settings.height_px = 1640;
    std::vector<CalibrationPair> pairs = somePairs();
    for (CalibrationPair& pair : pairs)
        pair.pixel.y() += 204.0;
    EXPECT_EQ(found(pairs, settings).warnings, Warnings{});
    EXPECT_EQ(found(swapped(pairs), settings).warnings, Warnings{});
}

TEST(CalibrationWarning, pixelsOutsideTheImageAndPointsBeyondTheEndsAreTold) {
    CalibrationSettings small;
    small.width_px = 1000;
    small.height_px = 1000;
    EXPECT_EQ(found(somePairs(), small).warnings, Warnings{CalibrationWarning::outsideImage});
    CalibrationSettings brief;
    brief.surface.highest_z_m = 0.08;
    EXPECT_EQ(found(somePairs(), brief).warnings, Warnings{CalibrationWarning::beyondEnds});
}

TEST(CalibrationWarning, pointsOnTheAxisHaveNoFactor) {
    EXPECT_FALSE(surfaceFactorOf({}, {}));
    const std::vector<CalibrationPair> axis{{{1.0, 2.0}, {0.0, 0.0, 0.01}}, {{3.0, 4.0}, {0.0, 0.0, 0.02}}};
    EXPECT_FALSE(surfaceFactorOf(axis, {}));
    Calibration calibration{CylinderCamera(*CameraModel::create(paperCamera()), {})};
    EXPECT_EQ(warningsOf(axis, calibration), Warnings{CalibrationWarning::offSurface});
    EXPECT_EQ(warningsOf({}, calibration), Warnings{CalibrationWarning::offSurface});
    EXPECT_NE(describe(CalibrationWarning::offSurface, calibration, 1.0).indexOf("axis"), -1);
    const std::vector<CalibrationPair> one{{{1.0, 2.0}, {0.05, 0.0, 0.01}}};
    const auto factor = surfaceFactorOf(one, {});
    ASSERT_TRUE(factor);
    EXPECT_EQ(factor->value, 0.5);
    EXPECT_EQ(factor->standardError, 0.0);
}

TEST(CalibrationWarning, eachHasANameAndAText) {
    const Calibration calibration{CylinderCamera(*CameraModel::create(paperCamera()), {})};
    std::set<std::string> names;
    std::set<std::string> texts;
    for (const CalibrationWarning warning : kCalibrationWarnings) {
        names.insert(toString(warning));
        texts.insert(describe(warning, calibration, 1.0).toStdString());
    }
    EXPECT_EQ(names.size(), kCalibrationWarnings.size());
    EXPECT_EQ(texts.size(), kCalibrationWarnings.size());
    EXPECT_FALSE(texts.contains(""));
}

} // namespace
} // namespace teleta::vision
