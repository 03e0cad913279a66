// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/camera_start.h"
#include "tests/backend/vision/simulated_pairs.h"

#include <gtest/gtest.h>

namespace teleta::vision {
namespace {

Calibration calibrated(const std::vector<CalibrationPair>& pairs,
                       CalibrationMethod method = CalibrationMethod::robust) {
    const auto calibration = calibrate(pairs, {}, method);
    EXPECT_TRUE(calibration) << toString(calibration.error());
    return *calibration;
}

TEST(DirectLinearCamera, isExactForACameraWithoutDistortion) {
    CameraLottery lottery(31);
    for (int trial = 0; trial < 20; ++trial) {
        CameraParameters truth = lottery.camera();
        truth.distortion = {};
        truth.skew_px = lottery.uniform(-5.0, 5.0);
        const SimulatedPairs simulated = simulatePairs(truth, {}, lottery);
        const auto found = directLinearCamera(simulated.pairs);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->mirrored, truth.mirrored);
        EXPECT_LT((found->cameraMatrix_px() - truth.cameraMatrix_px()).norm(), 1e-5);
        EXPECT_LT((found->R_Camera_Sensor - truth.R_Camera_Sensor).norm(), 1e-8);
        EXPECT_LT((found->p_Sensor_Camera_m - truth.p_Sensor_Camera_m).norm(), 1e-9);
    }
}

TEST(AlignedCameras, startNearTheTrueCameraAlthoughAThirdOfThePairsIsWrong) {
    CameraLottery lottery(37);
    for (int trial = 0; trial < 10; ++trial) {
        const CameraParameters truth = lottery.camera();
        const SimulatedPairs simulated = simulatePairs(truth, {0.5, 0.33}, lottery);
        const auto starts = alignedCameras(simulated.pairs, 1640, 1232);
        ASSERT_FALSE(starts.empty());
        EXPECT_EQ(starts.front().mirrored, truth.mirrored);
        EXPECT_NEAR(starts.front().fx_px / truth.fx_px, 1.0, 0.3);
        EXPECT_LT((starts.front().p_Sensor_Camera_m - truth.p_Sensor_Camera_m).norm(), 0.01);
    }
}

TEST(CameraCalibration, findsTheCameraOfExactPairs) {
    CameraLottery lottery(41);
    for (const CalibrationMethod method : {CalibrationMethod::leastSquares, CalibrationMethod::robust}) {
        const CameraParameters truth = lottery.camera();
        const SimulatedPairs simulated = simulatePairs(truth, {}, lottery);
        const Calibration calibration = calibrated(simulated.pairs, method);
        EXPECT_EQ(calibration.kept, simulated.pairs.size());
        EXPECT_EQ(calibration.camera.camera().parameters().mirrored, truth.mirrored);
        EXPECT_LT(calibration.rms_px, 1e-3) << toString(method);
        EXPECT_LT(surfaceErrors(truth, calibration.camera).mean_m(), 1e-6) << toString(method);
    }
}

TEST(CameraCalibration, findsEitherHandedness) {
    CameraLottery lottery(43);
    CameraParameters truth = paperCamera();
    for (const bool mirrored : {false, true}) {
        truth.mirrored = mirrored;
        const SimulatedPairs simulated = simulatePairs(truth, {0.5, 0.2}, lottery);
        EXPECT_EQ(calibrated(simulated.pairs).camera.camera().parameters().mirrored, mirrored);
    }
}

TEST(CameraCalibration, leavesOutWrongPairsAndKeepsTheRightOnes) {
    CameraLottery lottery(47);
    const CameraParameters truth = paperCamera();
    const SimulatedPairs simulated = simulatePairs(truth, {0.5, 0.2}, lottery);
    const Calibration calibration = calibrated(simulated.pairs);
    std::size_t rightKept = 0;
    std::size_t right = 0;
    for (std::size_t i = 0; i < simulated.pairs.size(); ++i) {
        right += simulated.good[i] ? 1 : 0;
        rightKept += simulated.good[i] && calibration.residuals[i].kept ? 1 : 0;
        EXPECT_TRUE(simulated.good[i] || !calibration.residuals[i].kept) << i;
    }
    EXPECT_GT(rightKept, 0.95 * static_cast<double>(right));
    EXPECT_NEAR(calibration.camera.noise_px(), 0.5, 0.05);
    EXPECT_LT(surfaceErrors(truth, calibration.camera).mean_m(), 1e-4);
    EXPECT_FALSE(calibration.isStructured());
}

TEST(CameraCalibration, tellsItsOwnErrorInMeanAndRootMeanSquare) {
    CameraLottery lottery(53);
    const SimulatedPairs simulated = simulatePairs(paperCamera(), {0.5, 0.1}, lottery);
    const Calibration calibration = calibrated(simulated.pairs);
    double squares = 0.0;
    double sum = 0.0;
    double sum_m = 0.0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < simulated.pairs.size(); ++i) {
        if (!calibration.residuals[i].kept)
            continue;
        ++kept;
        const auto pixel = calibration.camera.camera().project(simulated.pairs[i].p_Sensor_m);
        ASSERT_TRUE(pixel);
        const double error = (*pixel - simulated.pairs[i].pixel).norm();
        squares += error * error;
        sum += error;
        sum_m +=
            (*calibration.camera.locate_m(simulated.pairs[i].pixel) - simulated.pairs[i].p_Sensor_m).norm();
    }
    const auto count = static_cast<double>(kept);
    EXPECT_EQ(calibration.kept, kept);
    EXPECT_NEAR(calibration.rms_px, std::sqrt(squares / count), 1e-12);
    EXPECT_NEAR(calibration.mean_px, sum / count, 1e-12);
    EXPECT_NEAR(calibration.mean_error_m, sum_m / count, 1e-12);
}

TEST(CameraCalibration, theOrderOfThePairsDoesNotMatter) {
    CameraLottery lottery(59);
    const CameraParameters truth = paperCamera();
    const SimulatedPairs simulated = simulatePairs(truth, {0.5, 0.2}, lottery);
    std::vector<CalibrationPair> reversed(simulated.pairs.rbegin(), simulated.pairs.rend());
    const Calibration one = calibrated(simulated.pairs);
    const Calibration other = calibrated(reversed);
    ASSERT_EQ(one.kept, other.kept);
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(300.0, 500.0), Eigen::Vector2d(900.0, 900.0)})
        EXPECT_LT((*one.camera.locate_m(pixel) - *other.camera.locate_m(pixel)).norm(), 1e-7);
}

TEST(CameraCalibration, aHoleOfTheShellThatIsUsedTwiceDoesNoHarm) {
    CameraLottery lottery(61);
    const CameraParameters truth = paperCamera();
    SimulatedPairs simulated = simulatePairs(truth, {0.5, 0.0}, lottery);
    simulated.pairs.insert(simulated.pairs.end(), simulated.pairs.begin(), simulated.pairs.begin() + 50);
    EXPECT_LT(surfaceErrors(truth, calibrated(simulated.pairs).camera).mean_m(), 1e-4);
}

TEST(CameraCalibration, theLensModelIncreasesFartherThanThePairsReach) {
    CameraLottery lottery(67);
    for (int trial = 0; trial < 5; ++trial) {
        const CameraParameters truth = lottery.camera();
        const Calibration calibration = calibrated(simulatePairs(truth, {0.5, 0.2}, lottery).pairs);
        const double reach = CameraModel::create(truth)->validRadius();
        // 1.25 is the ring nearest to the lens.
        EXPECT_GT(calibration.camera.camera().validRadius(), std::min(1.6, reach));
    }
}

TEST(CameraCalibration, residualsWithAPatternAreNoticed) {
    CameraLottery lottery(71);
    SimulatedPairs simulated = simulatePairs(paperCamera(), {0.05, 0.0}, lottery);
    // A shell that has slipped on one side; no camera model describes that.
    for (CalibrationPair& pair : simulated.pairs) {
        if (pair.p_Sensor_m.x() > 0.0)
            pair.p_Sensor_m.z() += 0.0004 * std::sin(200.0 * pair.p_Sensor_m.z());
    }
    EXPECT_TRUE(calibrated(simulated.pairs, CalibrationMethod::leastSquares).isStructured());
}

TEST(CameraCalibration, methodsHaveNames) {
    for (const CalibrationMethod method : kCalibrationMethods)
        EXPECT_EQ(calibrationMethod(toString(method)), method);
    EXPECT_FALSE(calibrationMethod("ransac"));
}

} // namespace
} // namespace teleta::vision
