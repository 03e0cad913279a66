// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/vision/foreign_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace teleta::vision {
namespace {

constexpr int kCamerasPerLens = 40;
/// The last quarter of the tube.
constexpr double kFar_m = 0.075;

struct OfALens {
    Coverage whole;
    Coverage far;
    double worstFar = 1.0;
    double uncertainty2_m2 = 0.0;
    int flagged = 0;
    int refused = 0;

    /// Error over the uncertainty that is told, both root mean square.
    [[nodiscard]] double errorOverTold(int cameras) const {
        return whole.rms_m() / std::sqrt(uncertainty2_m2 / (cameras - refused));
    }
};

OfALens measure(ForeignLens lens, const ForeignPairs& how, const char* name) {
    ForeignLottery lottery(211);
    OfALens result;
    for (int i = 0; i < kCamerasPerLens; ++i) {
        const ForeignCamera truth = lottery.camera(lens);
        const auto calibration = calibrate(lottery.pairs(truth, how), {}, CalibrationMethod::robust);
        if (!calibration) {
            ++result.refused;
            continue;
        }
        result.flagged += calibration->isReliable() ? 0 : 1;
        const Coverage far = coverageOf(truth, calibration->camera, kFar_m);
        result.whole += coverageOf(truth, calibration->camera);
        result.far += far;
        result.worstFar = std::min(result.worstFar, far.share());
        result.uncertainty2_m2 += calibration->uncertainty_m * calibration->uncertainty_m;
    }
    std::printf("%s, %s: covered %.3f, far end %.3f, there the worst camera %.2f; error over the uncertainty "
                "told %.2f; %d flagged, %d refused\n",
                nameOf(lens), name, result.whole.share(), result.far.share(), result.worstFar,
                result.errorOverTold(kCamerasPerLens), result.flagged, result.refused);
    return result;
}

/// The bounds leave room for the scatter of 40 cameras: coverage_benchmark has the shares themselves.
TEST(CameraCoverage, intervalsHoldThePointUnderLensesThatTheModelDoesNotKnow) {
    Coverage all;
    int flagged = 0;
    for (const ForeignLens lens : kForeignLenses) {
        const OfALens full = measure(lens, {}, "250 holes");
        EXPECT_GT(full.whole.share(), 0.90) << nameOf(lens);
        EXPECT_LT(full.errorOverTold(kCamerasPerLens), 1.25) << nameOf(lens);
        EXPECT_LT(full.whole.notLocated, 1e-3 * full.whole.asked) << nameOf(lens);
        EXPECT_EQ(full.refused, 0) << nameOf(lens);
        all += full.whole;
        flagged += full.flagged;
    }
    EXPECT_GT(all.share(), 0.92);
    EXPECT_LT(all.share(), 0.98);
    EXPECT_LE(flagged, kCamerasPerLens * static_cast<int>(kForeignLenses.size()) / 20);
}

TEST(CameraCoverage, theFarEndIsCoveredFromTheFourNearestRings) {
    Coverage all;
    for (const ForeignLens lens : kForeignLenses) {
        const OfALens near = measure(lens, {.nearest_m = 0.036}, "four nearest rings");
        EXPECT_GT(near.far.share(), 0.88) << nameOf(lens);
        EXPECT_LT(near.errorOverTold(kCamerasPerLens), 1.25) << nameOf(lens);
        all += near.far;
    }
    EXPECT_GT(all.share(), 0.90);
}

TEST(CameraCoverage, aForgottenHoleFactorAndSwappedPixelsAreToldForEachLens) {
    for (const ForeignLens lens : kForeignLenses) {
        ForeignLottery lottery(223);
        for (int i = 0; i < 8; ++i) {
            const ForeignCamera truth = lottery.camera(lens);
            const auto holes =
                calibrate(lottery.pairs(truth, {.holeFactor = 0.97}), {}, CalibrationMethod::robust);
            ASSERT_TRUE(holes) << nameOf(lens) << i;
            EXPECT_EQ(holes->warnings, std::vector{CalibrationWarning::offSurface}) << nameOf(lens) << i;
            EXPECT_NEAR(holes->surfaceFactor->value, 0.97, 1e-9) << nameOf(lens) << i;
            const auto swapped =
                calibrate(lottery.pairs(truth, {.swapped = true}), {}, CalibrationMethod::robust);
            ASSERT_TRUE(swapped) << nameOf(lens) << i;
            EXPECT_EQ(swapped->warnings, std::vector{CalibrationWarning::swappedPixels}) << nameOf(lens) << i;
        }
    }
}

} // namespace
} // namespace teleta::vision
