// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/automatic_threshold.h"
#include "backend/contact/tactile_features.h"
#include "tests/backend/contact/allocation_count.h"
#include "tests/backend/contact/contact_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace teleta::contact;
using namespace teleta::contact::test;
using teleta::core::ArrayLayout;

namespace {

constexpr double kPitch_m = kPaperArray.pitchX_m;
constexpr double kTaxel_m2 = kPitch_m * kPitch_m;
constexpr double kQuarterTurn_rad = std::numbers::pi / 2.0;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TactileFeatures featuresOf(const Frame& frame, const FeatureSettings& settings = {}) {
    return FeatureExtractor(frame.layout, settings).compute(frame.load_N);
}

void expectNoContact(const TactileFeatures& features) {
    EXPECT_EQ(features.type, ContactType::none);
    EXPECT_EQ(features.active, 0);
    EXPECT_FALSE(features.copX_m || features.copY_m);
    EXPECT_FALSE(features.cocX_m || features.cocY_m);
    EXPECT_FALSE(features.dzmpX_m || features.dzmpY_m);
    EXPECT_FALSE(features.alphaZ_rad || features.lambda1_m2 || features.lambda2_m2);
}

/// A blob of 2 rows, with its columns as wide apart as the ratio of eigenvalues wants it:
/// lambda1/lambda2 = (columns^2 - 1)/(rows^2 - 1) for equal loads.
Frame bar(int columns) {
    return block(kPaperArray, 2, 3, 2, 1 + columns, 1.0F);
}

} // namespace

// Three taxels of a hand-computed example: 1 N at (row 1, column 2), 2 N at (1, 4), 1 N at (3, 4).
// In taxels from the centre (6.5, 2.5): x = -4.5, -2.5, -2.5, y = -1.5, -1.5, 0.5.
class HandComputedFeatures : public ::testing::Test {
protected:
    HandComputedFeatures() {
        frame.at(1, 2) = 1.0F;
        frame.at(1, 4) = 2.0F;
        frame.at(3, 4) = 1.0F;
    }
    Frame frame;
};

TEST_F(HandComputedFeatures, forceIsTheSumOfTheLoads) {
    EXPECT_EQ(featuresOf(frame).force_N, 4.0);
    EXPECT_EQ(featuresOf(frame).peak_N, 2.0);
    EXPECT_EQ(featuresOf(frame).active, 3);
    EXPECT_EQ(featuresOf(frame).dead, 0);
}

TEST_F(HandComputedFeatures, centreOfPressureIsTheFirstMomentOverTheForce) {
    // x: (-4.5 - 5 - 2.5)/4 = -3; y: (-1.5 - 3 + 0.5)/4 = -1.
    EXPECT_DOUBLE_EQ(*featuresOf(frame).copX_m, -3.0 * kPitch_m);
    EXPECT_DOUBLE_EQ(*featuresOf(frame).copY_m, -1.0 * kPitch_m);
}

TEST_F(HandComputedFeatures, centreOfContactIsTheCentroidOfTheActiveTaxels) {
    EXPECT_DOUBLE_EQ(*featuresOf(frame).cocX_m, -9.5 / 3.0 * kPitch_m);
    EXPECT_DOUBLE_EQ(*featuresOf(frame).cocY_m, -2.5 / 3.0 * kPitch_m);
}

TEST_F(HandComputedFeatures, dzmpIsCentreOfPressureLessCentreOfContactWithTheAxesExchanged) {
    EXPECT_NEAR(*featuresOf(frame).dzmpX_m, (-1.0 + 2.5 / 3.0) * kPitch_m, 1e-17);
    EXPECT_NEAR(*featuresOf(frame).dzmpY_m, (-3.0 + 9.5 / 3.0) * kPitch_m, 1e-17);
}

TEST_F(HandComputedFeatures, eigenvaluesAreThoseOfTheCovarianceWithOneLessInTheDenominator) {
    // Deviations (-4/3, -2/3), (2/3, -2/3), (2/3, 4/3): xx = yy = 8/3, xy = 4/3, over n - 1 = 2.
    EXPECT_NEAR(*featuresOf(frame).lambda1_m2, 2.0 * kTaxel_m2, 1e-15 * kTaxel_m2);
    EXPECT_NEAR(*featuresOf(frame).lambda2_m2, 2.0 / 3.0 * kTaxel_m2, 1e-15 * kTaxel_m2);
    EXPECT_DOUBLE_EQ(*featuresOf(frame).alphaZ_rad, std::numbers::pi / 4.0);
}

TEST_F(HandComputedFeatures, theCovarianceRunsOverTheTaxelsInContactAndNotOverTheImage) {
    // (B.4) as printed: n = 84 in the means and in the denominator, and all other taxels at the origin.
    const double n = 84.0;
    const double xx = (4.5 * 4.5 + 2.5 * 2.5 + 2.5 * 2.5 - 9.5 * 9.5 / n) / (n - 1.0);
    const double yy = (1.5 * 1.5 + 1.5 * 1.5 + 0.5 * 0.5 - 2.5 * 2.5 / n) / (n - 1.0);
    const double xy = (4.5 * 1.5 + 2.5 * 1.5 - 2.5 * 0.5 - 9.5 * 2.5 / n) / (n - 1.0);
    const double printed_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
    const double printedLambda1 = 0.5 * (xx + yy + std::hypot(xx - yy, 2.0 * xy));
    const TactileFeatures features = featuresOf(frame);
    EXPECT_GT(std::abs(*features.alphaZ_rad - printed_rad), 0.4);
    EXPECT_GT(std::abs(*features.lambda1_m2 / kTaxel_m2 - printedLambda1), 1.0);
}

TEST_F(HandComputedFeatures, weightedOrientationCountsEachTaxelWithItsLoad) {
    // Mean (-3, -1), weights 1, 2, 1: xx = 2.25 + 0.5 + 0.25 = 3, yy = 0.25 + 0.5 + 2.25 = 3,
    // xy = 0.75 - 0.5 + 0.75 = 1, over F - sum f^2/F = 4 - 6/4 = 2.5.
    const TactileFeatures features = featuresOf(frame, {.orientation = OrientationMode::weighted});
    EXPECT_NEAR(*features.lambda1_m2, 4.0 / 2.5 * kTaxel_m2, 1e-15 * kTaxel_m2);
    EXPECT_NEAR(*features.lambda2_m2, 2.0 / 2.5 * kTaxel_m2, 1e-15 * kTaxel_m2);
    EXPECT_DOUBLE_EQ(*features.alphaZ_rad, std::numbers::pi / 4.0);
}

TEST(TactileFeatures, weightedAndBinarisedAgreeForEqualLoads) {
    Frame frame = block(kPaperArray, 1, 2, 3, 8, 0.7F);
    frame.at(3, 9) = 0.7F;
    const TactileFeatures binarised = featuresOf(frame);
    const TactileFeatures weighted = featuresOf(frame, {.orientation = OrientationMode::weighted});
    EXPECT_NEAR(*weighted.alphaZ_rad, *binarised.alphaZ_rad, 1e-14);
    EXPECT_NEAR(*weighted.lambda1_m2, *binarised.lambda1_m2, 1e-13 * kTaxel_m2);
    EXPECT_NEAR(*weighted.lambda2_m2, *binarised.lambda2_m2, 1e-13 * kTaxel_m2);
}

TEST(TactileFeatures, weightedOrientationFollowsTheHeavierTaxels) {
    // A symmetric cross whose bar along y carries most of the load.
    Frame frame;
    for (int i = 1; i <= 5; ++i) {
        frame.at(2, 4 + i) = 0.3F;
        frame.at(i - 1, 7) = 2.0F;
    }
    EXPECT_FALSE(featuresOf(frame).alphaZ_rad);
    EXPECT_DOUBLE_EQ(*featuresOf(frame, {.orientation = OrientationMode::weighted}).alphaZ_rad,
                     kQuarterTurn_rad);
}

TEST(TactileFeatures, anEmptyFrameHasNoFeature) {
    const TactileFeatures features = featuresOf(Frame());
    expectNoContact(features);
    EXPECT_EQ(features.force_N, 0.0);
    EXPECT_EQ(features.peak_N, 0.0);
}

TEST(TactileFeatures, noiseBelowTheThresholdHasAForceButNoCentre) {
    const TactileFeatures features = featuresOf(block(kPaperArray, 0, 1, 0, 13, 0.125F));
    expectNoContact(features);
    EXPECT_EQ(features.force_N, 28 * 0.125);
    EXPECT_EQ(features.peak_N, 0.125);
}

TEST(TactileFeatures, aFrameOfAnotherSizeHasNoFeature) {
    expectNoContact(FeatureExtractor(kPaperArray).compute(std::vector<float>(83, 1.0F)));
}

TEST(TactileFeatures, oneActiveTaxelHasACentreButNoOrientation) {
    Frame frame;
    frame.at(0, 13) = 1.0F;
    const TactileFeatures features = featuresOf(frame);
    EXPECT_EQ(features.type, ContactType::point);
    EXPECT_DOUBLE_EQ(*features.copX_m, 6.5 * kPitch_m);
    EXPECT_DOUBLE_EQ(*features.copY_m, -2.5 * kPitch_m);
    EXPECT_EQ(features.cocX_m, features.copX_m);
    EXPECT_EQ(features.dzmpX_m, 0.0);
    EXPECT_EQ(features.dzmpY_m, 0.0);
    EXPECT_FALSE(features.alphaZ_rad || features.lambda1_m2 || features.lambda2_m2);
}

TEST(TactileFeatures, anIsotropicBlobHasEigenvaluesButNoOrientation) {
    for (const OrientationMode mode : {OrientationMode::binarised, OrientationMode::weighted}) {
        const TactileFeatures features =
            featuresOf(block(kPaperArray, 1, 3, 5, 7, 0.3F), {.orientation = mode});
        EXPECT_EQ(features.type, ContactType::point);
        EXPECT_FALSE(features.alphaZ_rad);
        // Six of nine taxels are one taxel off the centre: 6/8.
        EXPECT_NEAR(*features.lambda1_m2, 0.75 * kTaxel_m2, 1e-14 * kTaxel_m2);
        EXPECT_NEAR(*features.lambda2_m2, 0.75 * kTaxel_m2, 1e-14 * kTaxel_m2);
    }
}

TEST(TactileFeatures, aSaturatedArrayIsOneEvenContact) {
    const TactileFeatures features = featuresOf(block(kPaperArray, 0, 5, 0, 13, 2.89F));
    EXPECT_EQ(features.active, 84);
    EXPECT_NEAR(features.force_N, 84 * 2.89, 1e-5);
    EXPECT_NEAR(*features.copX_m, 0.0, 1e-16);
    EXPECT_NEAR(*features.copY_m, 0.0, 1e-16);
    EXPECT_EQ(*features.cocX_m, 0.0);
    EXPECT_EQ(*features.cocY_m, 0.0);
    EXPECT_EQ(*features.alphaZ_rad, 0.0);
    // Mean square of 14 and 6 evenly spaced points is (n^2 - 1)/12; 84/83 is n/(n - 1).
    EXPECT_NEAR(*features.lambda1_m2, 195.0 / 12.0 * 84.0 / 83.0 * kTaxel_m2, 1e-13 * kTaxel_m2);
    EXPECT_NEAR(*features.lambda2_m2, 35.0 / 12.0 * 84.0 / 83.0 * kTaxel_m2, 1e-13 * kTaxel_m2);
}

TEST(TactileFeatures, aPerfectLineIsAnEdgeWithASecondEigenvalueOfZero) {
    for (const OrientationMode mode : {OrientationMode::binarised, OrientationMode::weighted}) {
        const TactileFeatures features =
            featuresOf(block(kPaperArray, 3, 3, 2, 6, 1.0F), {.orientation = mode});
        EXPECT_EQ(features.type, ContactType::edge);
        EXPECT_EQ(*features.lambda2_m2, 0.0);
        EXPECT_NEAR(*features.lambda1_m2, 2.5 * kTaxel_m2, 1e-15 * kTaxel_m2);
        EXPECT_EQ(*features.alphaZ_rad, 0.0);
    }
}

TEST(TactileFeatures, anEdgeAlongYIsAtPlusNinetyDegreesAndNeverAtMinus) {
    Frame frame;
    std::mt19937 random(3);
    for (int trial = 0; trial < 100; ++trial) {
        frame = randomFrame(random, {6, 1, kPitch_m}, 0.3);
        const Frame wide = frame.moved(kPaperArray, [&](int row, int) { return std::pair{row, trial % 14}; });
        for (const OrientationMode mode : {OrientationMode::binarised, OrientationMode::weighted}) {
            const TactileFeatures features = featuresOf(wide, {.orientation = mode});
            if (features.active < 2)
                continue;
            EXPECT_EQ(features.type, ContactType::edge);
            EXPECT_EQ(*features.alphaZ_rad, kQuarterTurn_rad);
        }
    }
}

TEST(TactileFeatures, edgesJustBesideNinetyDegreesLieOnEitherSide) {
    // Six taxels along y with the last one shifted by a column.
    Frame frame;
    for (int row = 0; row < 5; ++row)
        frame.at(row, 7) = 1.0F;
    frame.at(5, 8) = 1.0F;
    const double leaning_rad = *featuresOf(frame).alphaZ_rad;
    EXPECT_GT(leaning_rad, 1.3);
    EXPECT_LT(leaning_rad, kQuarterTurn_rad);
    EXPECT_NEAR(*featuresOf(frame.mirrored()).alphaZ_rad, -leaning_rad, 1e-15);
}

TEST(TactileFeatures, anObliqueEdgeAcrossTheCornerHasTheAngleOfItsLine) {
    Frame frame;
    for (int i = 0; i < 5; ++i)
        frame.at(4 - i, i) = 1.0F;
    const TactileFeatures features = featuresOf(frame);
    EXPECT_EQ(features.type, ContactType::edge);
    EXPECT_DOUBLE_EQ(*features.alphaZ_rad, -std::numbers::pi / 4.0);
    EXPECT_EQ(*features.lambda2_m2, 0.0);
    EXPECT_DOUBLE_EQ(*features.lambda1_m2, 5.0 * kTaxel_m2);
    EXPECT_DOUBLE_EQ(*features.cocX_m, -4.5 * kPitch_m);
    EXPECT_DOUBLE_EQ(*features.cocY_m, -0.5 * kPitch_m);
}

TEST(TactileFeatures, anEdgeStaysAnEdgeWhileTheRatioIsBetweenTheTwoLimits) {
    // Ratios of 2 rows and 3 to 5 columns: 8/3, 5 and 8. Becomes an edge over 4, a point below 2.5.
    FeatureExtractor extractor(kPaperArray);
    EXPECT_EQ(extractor.compute(bar(3).load_N).type, ContactType::point);
    EXPECT_EQ(extractor.compute(bar(4).load_N).type, ContactType::edge);
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(extractor.compute(bar(3).load_N).type, ContactType::edge) << "chatters";
        EXPECT_EQ(extractor.compute(bar(4).load_N).type, ContactType::edge);
    }
    EXPECT_EQ(extractor.compute(bar(2).load_N).type, ContactType::point);
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(extractor.compute(bar(3).load_N).type, ContactType::point) << "chatters";
}

TEST(TactileFeatures, theMemoryOfTheEdgeEndsWithTheContactAndWithReset) {
    FeatureExtractor extractor(kPaperArray);
    EXPECT_EQ(extractor.compute(bar(4).load_N).type, ContactType::edge);
    EXPECT_EQ(extractor.compute(Frame().load_N).type, ContactType::none);
    EXPECT_EQ(extractor.compute(bar(3).load_N).type, ContactType::point);

    EXPECT_EQ(extractor.compute(bar(4).load_N).type, ContactType::edge);
    extractor.reset();
    EXPECT_EQ(extractor.compute(bar(3).load_N).type, ContactType::point);
}

TEST(TactileFeatures, limitsOfTheRatioCanBeSet) {
    // Exactly 5: not over 5, and not below 5.
    EXPECT_EQ(featuresOf(bar(4), {.edgeRatio = 5.0}).type, ContactType::point);
    EXPECT_EQ(featuresOf(bar(4), {.edgeRatio = 4.999}).type, ContactType::edge);
}

TEST(TactileFeatures, aTaxelAtTheThresholdIsActive) {
    Frame frame;
    frame.at(2, 2) = 0.2F;
    frame.at(2, 4) = std::nextafter(0.2F, 0.0F);
    EXPECT_EQ(featuresOf(frame).active, 1);
}

TEST(TactileFeatures, aThresholdThatIsNotPositiveMakesEveryLoadActive) {
    Frame frame;
    frame.at(2, 2) = std::numeric_limits<float>::denorm_min();
    frame.at(2, 4) = 1.0F;
    for (const double threshold_N : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e-60})
        EXPECT_EQ(featuresOf(frame, {.threshold_N = threshold_N}).active, 2) << threshold_N;
}

TEST(TactileFeatures, momentsRunOverTheImageOrOverTheActiveTaxels) {
    Frame frame;
    frame.at(2, 2) = 1.0F;
    frame.at(2, 10) = 0.125F;
    const TactileFeatures image = featuresOf(frame);
    EXPECT_EQ(image.force_N, 1.125);
    EXPECT_DOUBLE_EQ(*image.copX_m, (-4.5 + 0.125 * 3.5) / 1.125 * kPitch_m);
    EXPECT_DOUBLE_EQ(*image.cocX_m, -4.5 * kPitch_m);

    const TactileFeatures active = featuresOf(frame, {.range = MomentRange::active});
    EXPECT_EQ(active.force_N, 1.0);
    EXPECT_DOUBLE_EQ(*active.copX_m, -4.5 * kPitch_m);
    EXPECT_EQ(active.dzmpY_m, 0.0);

    frame.at(2, 2) = 0.0F;
    EXPECT_EQ(featuresOf(frame, {.range = MomentRange::active}).force_N, 0.0);
}

TEST(TactileFeatures, taxelsThatAreNotFiniteOrNegativeAreLeftOutAndCounted) {
    Frame clean = block(kPaperArray, 1, 4, 3, 9, 0.5F);
    for (const int column : {3, 5, 7, 9})
        clean.at(2, column) = 0.0F;
    Frame broken = clean;
    broken.at(2, 3) = kNan;
    broken.at(2, 5) = kInfinity;
    broken.at(2, 7) = -kInfinity;
    broken.at(2, 9) = -1.0F;
    for (const OrientationMode mode : {OrientationMode::binarised, OrientationMode::weighted}) {
        const TactileFeatures expected = featuresOf(clean, {.orientation = mode});
        const TactileFeatures features = featuresOf(broken, {.orientation = mode});
        EXPECT_EQ(features.dead, 4);
        EXPECT_EQ(features.active, expected.active);
        EXPECT_EQ(features.force_N, expected.force_N);
        EXPECT_EQ(features.copX_m, expected.copX_m);
        EXPECT_EQ(features.cocY_m, expected.cocY_m);
        EXPECT_EQ(features.lambda1_m2, expected.lambda1_m2);
        EXPECT_EQ(features.alphaZ_rad, expected.alphaZ_rad);
    }
}

TEST(TactileFeatures, aMaskedTaxelCountsAsDeadOnceEvenWhenItIsNotFinite) {
    Frame frame;
    frame.at(2, 2) = 1.0F;
    frame.at(2, 3) = 5.0F;
    frame.at(2, 4) = kNan;
    std::vector<std::uint8_t> dead(84, 0);
    dead[frame.index(2, 3)] = 1;
    dead[frame.index(2, 4)] = 1;
    const TactileFeatures features = FeatureExtractor(kPaperArray).compute(frame.load_N, dead);
    EXPECT_EQ(features.dead, 2);
    EXPECT_EQ(features.active, 1);
    EXPECT_EQ(features.force_N, 1.0);
    EXPECT_EQ(features.peak_N, 1.0);
}

TEST(TactileFeatures, aFrameOfDeadTaxelsHasNoContact) {
    Frame frame = block(kPaperArray, 0, 5, 0, 13, kNan);
    const TactileFeatures features = featuresOf(frame, {.automaticThreshold = true});
    expectNoContact(features);
    EXPECT_EQ(features.dead, 84);
    EXPECT_EQ(features.force_N, 0.0);
}

TEST(TactileFeatures, computeAllocatesNothing) {
    for (const bool automatic : {false, true}) {
        for (const OrientationMode mode : {OrientationMode::binarised, OrientationMode::weighted}) {
            FeatureExtractor extractor(kPaperArray, {.automaticThreshold = automatic, .orientation = mode});
            Frame frame = bar(4);
            frame.at(0, 0) = kNan;
            const std::size_t before = allocationCount();
            const TactileFeatures features = extractor.compute(frame.load_N);
            EXPECT_EQ(allocationCount(), before);
            EXPECT_EQ(features.active, 8);
        }
    }
    Frame frame = bar(4);
    FeatureExtractor extractor(kPaperArray);
    const std::size_t before = allocationCount();
    EXPECT_EQ(extractor.compute(frame.load_N).active, 8);
    EXPECT_EQ(allocationCount(), before);
}

TEST(TactileFeatures, contactTypesHaveNames) {
    EXPECT_EQ(std::string(toString(ContactType::none)), "none");
    EXPECT_EQ(std::string(toString(ContactType::point)), "point");
    EXPECT_EQ(std::string(toString(ContactType::edge)), "edge");
}

TEST(AutomaticThreshold, isThreeDeviationsOverTheMeanOfTheBackground) {
    // Background of 0.1 and 0.3 in equal parts: mean 0.2, deviation 0.1; the contact of 10 is far away.
    std::vector<float> loads(40, 0.1F);
    std::fill(loads.begin() + 20, loads.end(), 0.3F);
    loads.resize(50, 10.0F);
    // Otsu's split is the first of equally good levels, the bin behind 0.3: 8/256 of the peak.
    EXPECT_NEAR(*automaticThreshold(loads), std::min(0.5, 8.0 / 256.0 * 10.0), 1e-6);
    // With the background in one level there is no spread: the mean.
    std::vector<float> even(40, 0.3F);
    even.resize(50, 10.0F);
    EXPECT_NEAR(*automaticThreshold(even), 0.3, 1e-6);
}

TEST(AutomaticThreshold, isNotThereWhenNothingStandsOut) {
    EXPECT_FALSE(automaticThreshold({}));
    EXPECT_FALSE(automaticThreshold(std::vector<float>(84, 0.0F)));
    EXPECT_FALSE(automaticThreshold(std::vector<float>(84, 2.89F)));
}

TEST(AutomaticThreshold, scalesWithTheLoads) {
    std::mt19937 random(11);
    const Frame frame = randomFrame(random, kPaperArray, 0.6);
    const double threshold_N = *automaticThreshold(frame.load_N);
    EXPECT_NEAR(*automaticThreshold(frame.scaled(1e12F).load_N), 1e12 * threshold_N, 1e6 * threshold_N);
    EXPECT_NEAR(*automaticThreshold(frame.scaled(1e-12F).load_N), 1e-12 * threshold_N, 1e-18 * threshold_N);
}

TEST(AutomaticThreshold, separatesNoiseFromAContact) {
    std::mt19937 random(12);
    std::normal_distribution<float> noise(0.0F, 0.02F);
    Frame frame;
    for (float& load : frame.load_N)
        load = std::abs(noise(random));
    for (int row = 2; row <= 3; ++row)
        for (int column = 4; column <= 9; ++column)
            frame.at(row, column) += 0.3F;
    const TactileFeatures features = featuresOf(frame, {.threshold_N = 1e-6, .automaticThreshold = true});
    EXPECT_EQ(features.active, 12);
    EXPECT_EQ(features.type, ContactType::edge);
    EXPECT_LT(features.threshold_N, 0.15);
    // The threshold that was set is the lower bound.
    EXPECT_EQ(featuresOf(frame, {.threshold_N = 0.25, .automaticThreshold = true}).threshold_N, 0.25);
}
