// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/vision/simulated_pairs.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace teleta::vision {
namespace {

constexpr int kCameras = 200;

TEST(CameraCalibrationAccuracy, halfAPixelAndAFifthOfOutliersLeaveLessThanATenthOfAMillimetre) {
    CameraLottery lottery(101);
    double sum_m = 0.0;
    double worst_m = 0.0;
    double leastKept = 1.0;
    double mostOfUncertainty = 0.0;
    int located = 0;
    int notLocated = 0;
    double allRight = 0.0;
    double allKept = 0.0;
    for (int i = 0; i < kCameras; ++i) {
        const CameraParameters truth = lottery.camera();
        const SimulatedPairs simulated = simulatePairs(truth, {0.5, 0.2}, lottery);
        const auto calibration = calibrate(simulated.pairs, {}, CalibrationMethod::robust);
        ASSERT_TRUE(calibration) << i << " " << toString(calibration.error());
        const SurfaceErrors found = surfaceErrors(truth, calibration->camera);
        sum_m += found.mean_m();
        worst_m = std::max(worst_m, found.mean_m());
        located += static_cast<int>(found.errors_m.size());
        notLocated += found.notLocated;
        mostOfUncertainty = std::max(mostOfUncertainty, found.mean_m() / calibration->uncertainty_m);
        double right = 0.0;
        double rightKept = 0.0;
        for (std::size_t k = 0; k < simulated.pairs.size(); ++k) {
            right += simulated.good[k] ? 1.0 : 0.0;
            rightKept += simulated.good[k] && calibration->residuals[k].kept ? 1.0 : 0.0;
        }
        allRight += right;
        allKept += rightKept;
        leastKept = std::min(leastKept, rightKept / right);
    }
    const double mean_m = sum_m / kCameras;
    std::printf(
        "2D -> 3D over the whole surface, %d cameras: mean %.4f mm, worst camera %.4f mm; right pairs kept "
        "%.4f, least %.3f; largest error over the uncertainty told %.2f; %d of %d points have no ray\n",
        kCameras, 1e3 * mean_m, 1e3 * worst_m, allKept / allRight, leastKept, mostOfUncertainty, notLocated,
        located + notLocated);
    EXPECT_LT(mean_m, 1e-4);
    EXPECT_LT(worst_m, 2e-4);
    EXPECT_GT(leastKept, 0.95);
    EXPECT_LT(mostOfUncertainty, 3.0);
    EXPECT_LT(notLocated, 1e-3 * located);
}

/// Noise from none to 3 px, outliers from none to 60 %, shells with fewer holes, blocks of holes numbered
/// wrongly: the points that are located are right to three times the uncertainty told, or the calibration
/// says that something is wrong.
TEST(CameraCalibrationAccuracy, noWrongCalibrationPassesSilently) {
    CameraLottery lottery(103);
    int accepted = 0;
    int refused = 0;
    int warned = 0;
    double most = 0.0;
    for (int i = 0; i < kCameras; ++i) {
        const CameraParameters truth = lottery.camera();
        const PairErrors errors{lottery.uniform(0.0, 3.0), lottery.uniform(0.0, 0.6)};
        const int around = static_cast<int>(lottery.uniform(4.0, 25.0));
        const int along = static_cast<int>(lottery.uniform(2.0, 10.0));
        SimulatedPairs simulated = simulatePairs(truth, errors, lottery, around, along);
        if (i % 4 == 0) { // the holes of one part are numbered from the next line on
            const auto end = static_cast<std::size_t>(lottery.uniform(0.0, 0.6) *
                                                      static_cast<double>(simulated.pairs.size()));
            for (std::size_t k = 0; k + static_cast<std::size_t>(along) < end; ++k)
                simulated.pairs[k].pixel = simulated.pairs[k + static_cast<std::size_t>(along)].pixel;
        }
        const auto calibration = calibrate(simulated.pairs, {}, CalibrationMethod::robust);
        if (!calibration) {
            ++refused;
            continue;
        }
        if (calibration->isStructured()) {
            ++warned;
            continue;
        }
        ++accepted;
        const double error_m = surfaceErrors(truth, calibration->camera).mean_m();
        most = std::max(most, error_m / calibration->uncertainty_m);
        EXPECT_LT(error_m, 3.0 * calibration->uncertainty_m)
            << i << ": noise " << errors.noise_px << " px, outliers " << errors.outliers << ", pairs "
            << simulated.pairs.size() << ", kept " << calibration->kept;
    }
    std::printf("%d accepted, %d refused, %d with a warning; largest error over the uncertainty told %.2f\n",
                accepted, refused, warned, most);
    EXPECT_GT(accepted, kCameras / 4);
    EXPECT_GT(refused, 0);
}

} // namespace
} // namespace teleta::vision
