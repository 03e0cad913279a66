// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/tactile_features.h"
#include "tests/backend/contact/contact_frames.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>

using namespace teleta::contact;
using namespace teleta::contact::test;
using teleta::core::ArrayLayout;

namespace {

constexpr double kHalfTurn_rad = std::numbers::pi;

TactileFeatures featuresOf(const Frame& frame, const FeatureSettings& settings = {}) {
    return FeatureExtractor(frame.layout, settings).compute(frame.load_N);
}

/// Difference of two axes, which are the same after half a turn.
double axisError_rad(double a_rad, double b_rad) {
    return std::remainder(a_rad - b_rad, kHalfTurn_rad);
}

/// Rounding to single precision does not move an axis that is this distinct.
bool hasClearAxis(const TactileFeatures& features) {
    return features.alphaZ_rad && *features.lambda1_m2 > 1.01 * *features.lambda2_m2;
}

void expectSameShape(const TactileFeatures& a, const TactileFeatures& b) {
    ASSERT_EQ(a.type, b.type);
    ASSERT_EQ(a.active, b.active);
    ASSERT_NEAR(a.force_N, b.force_N, 1e-12 * b.force_N);
    ASSERT_EQ(a.peak_N, b.peak_N);
    ASSERT_EQ(a.lambda1_m2.has_value(), b.lambda1_m2.has_value());
    if (!a.lambda1_m2)
        return;
    ASSERT_NEAR(*a.lambda1_m2, *b.lambda1_m2, 1e-11 * *b.lambda1_m2);
    ASSERT_NEAR(*a.lambda2_m2, *b.lambda2_m2, 1e-11 * *b.lambda1_m2);
}

std::vector<FeatureSettings> allSettings() {
    std::vector<FeatureSettings> all;
    for (const OrientationMode orientation : {OrientationMode::binarised, OrientationMode::weighted})
        for (const MomentRange range : {MomentRange::image, MomentRange::active})
            all.push_back({.orientation = orientation, .range = range});
    return all;
}

} // namespace

// OpenCV is the peer: cv::moments for the sums, cv::PCACompute for the axis. Its image coordinates count
// from the first taxel, its covariance has n in the denominator.
TEST(FeaturesStability, equalsTheMomentsOfOpenCv) {
    std::mt19937 random(31);
    std::uniform_int_distribution<int> side(1, 70);
    for (int trial = 0; trial < 600; ++trial) {
        const ArrayLayout layout{side(random), side(random), 0.0034};
        Frame frame = randomFrame(random, layout, 0.1 * (trial % 10));
        const TactileFeatures features = featuresOf(frame);
        const cv::Mat image(layout.rows, layout.columns, CV_32F, frame.load_N.data());
        cv::Mat wide;
        image.convertTo(wide, CV_64F);
        const cv::Moments loads = cv::moments(wide);
        const cv::Mat binary = image >= 0.2F;
        cv::Mat ones;
        binary.convertTo(ones, CV_64F, 1.0 / 255.0);
        const cv::Moments taxels = cv::moments(ones);

        ASSERT_EQ(features.active, static_cast<int>(std::lround(taxels.m00)));
        ASSERT_NEAR(features.force_N, loads.m00, 1e-12 * loads.m00);
        if (features.active == 0)
            continue;
        const double tolerance_m = 1e-15 * 70;
        ASSERT_NEAR(*features.copX_m, layout.x_m(loads.m10 / loads.m00), tolerance_m);
        ASSERT_NEAR(*features.copY_m, layout.y_m(loads.m01 / loads.m00), tolerance_m);
        ASSERT_NEAR(*features.cocX_m, layout.x_m(taxels.m10 / taxels.m00), tolerance_m);
        ASSERT_NEAR(*features.cocY_m, layout.y_m(taxels.m01 / taxels.m00), tolerance_m);
        ASSERT_NEAR(*features.dzmpX_m,
                    layout.y_m(loads.m01 / loads.m00) - layout.y_m(taxels.m01 / taxels.m00), tolerance_m);
        ASSERT_NEAR(*features.dzmpY_m,
                    layout.x_m(loads.m10 / loads.m00) - layout.x_m(taxels.m10 / taxels.m00), tolerance_m);
    }
}

TEST(FeaturesStability, equalsThePrincipalAxesOfOpenCv) {
    std::mt19937 random(32);
    std::uniform_int_distribution<int> side(2, 40);
    int compared = 0;
    for (int trial = 0; trial < 600; ++trial) {
        const ArrayLayout layout{side(random), side(random), 0.0034};
        const Frame frame = randomFrame(random, layout, 0.1 * (trial % 10));
        const TactileFeatures features = featuresOf(frame);
        cv::Mat points;
        for (int row = 0; row < layout.rows; ++row) {
            for (int column = 0; column < layout.columns; ++column) {
                if (frame.at(row, column) < 0.2F)
                    continue;
                const cv::Mat point = (cv::Mat_<double>(1, 2) << layout.x_m(column), layout.y_m(row));
                points.push_back(point);
            }
        }
        if (points.rows < 2)
            continue;
        cv::Mat mean, axes, variances;
        cv::PCACompute(points, mean, axes, variances);
        const double toSample = points.rows / (points.rows - 1.0);
        const double lambda1_m2 = variances.at<double>(0) * toSample;
        const double lambda2_m2 = variances.rows > 1 ? variances.at<double>(1) * toSample : 0.0;
        ASSERT_NEAR(*features.lambda1_m2, lambda1_m2, 1e-12 * lambda1_m2);
        ASSERT_NEAR(*features.lambda2_m2, lambda2_m2, 1e-12 * lambda1_m2);
        if (!hasClearAxis(features))
            continue;
        ++compared;
        const double alpha_rad = std::atan2(axes.at<double>(0, 1), axes.at<double>(0, 0));
        ASSERT_NEAR(axisError_rad(*features.alphaZ_rad, alpha_rad), 0.0, 1e-11);
    }
    EXPECT_GT(compared, 400);
}

// The same in an independent way: the peer works on a cloud in which a taxel of load k is there k times.
TEST(FeaturesStability, weightedAxesEqualThoseOfACloudOfPointsByOpenCv) {
    std::mt19937 random(33);
    std::uniform_int_distribution<int> times(0, 9);
    for (int trial = 0; trial < 200; ++trial) {
        Frame frame;
        cv::Mat points;
        double squares = 0.0;
        for (int row = 0; row < 6; ++row) {
            for (int column = 0; column < 14; ++column) {
                const int count = times(random) - 4;
                if (count <= 0)
                    continue;
                frame.at(row, column) = static_cast<float>(count);
                squares += count * count;
                const cv::Mat point =
                    (cv::Mat_<double>(1, 2) << kPaperArray.x_m(column), kPaperArray.y_m(row));
                for (int i = 0; i < count; ++i)
                    points.push_back(point);
            }
        }
        const TactileFeatures features = featuresOf(frame, {.orientation = OrientationMode::weighted});
        cv::Mat mean, axes, variances;
        cv::PCACompute(points, mean, axes, variances);
        const double force = points.rows;
        const double toSample = force / (force - squares / force);
        ASSERT_NEAR(*features.lambda1_m2, variances.at<double>(0) * toSample, 1e-16);
        ASSERT_NEAR(*features.lambda2_m2, variances.at<double>(1) * toSample, 1e-16);
        if (hasClearAxis(features)) {
            ASSERT_NEAR(
                axisError_rad(*features.alphaZ_rad, std::atan2(axes.at<double>(0, 1), axes.at<double>(0, 0))),
                0.0, 1e-11);
        }
    }
}

TEST(FeaturesStability, followATranslation) {
    std::mt19937 random(34);
    const ArrayLayout layout{16, 20, 0.0034};
    for (const FeatureSettings& settings : allSettings()) {
        for (int trial = 0; trial < 100; ++trial) {
            const Frame frame = randomFrame(random, layout, 0.3, 4);
            const int rows = trial % 9 - 4;
            const int columns = trial % 7 - 3;
            const TactileFeatures before = featuresOf(frame, settings);
            const TactileFeatures after = featuresOf(frame.shifted(rows, columns), settings);
            expectSameShape(after, before);
            ASSERT_NEAR(*after.copX_m, *before.copX_m + columns * 0.0034, 1e-14);
            ASSERT_NEAR(*after.copY_m, *before.copY_m + rows * 0.0034, 1e-14);
            ASSERT_NEAR(*after.cocX_m, *before.cocX_m + columns * 0.0034, 1e-14);
            ASSERT_NEAR(*after.cocY_m, *before.cocY_m + rows * 0.0034, 1e-14);
            ASSERT_NEAR(*after.dzmpX_m, *before.dzmpX_m, 1e-14);
            ASSERT_NEAR(*after.dzmpY_m, *before.dzmpY_m, 1e-14);
            if (hasClearAxis(before)) {
                ASSERT_NEAR(axisError_rad(*after.alphaZ_rad, *before.alphaZ_rad), 0.0, 1e-9);
            }
        }
    }
}

TEST(FeaturesStability, followAMirrorAndAQuarterTurn) {
    std::mt19937 random(35);
    for (const FeatureSettings& settings : allSettings()) {
        for (int trial = 0; trial < 100; ++trial) {
            const Frame frame = randomFrame(random, {9, 17, 0.0034}, 0.009 * trial);
            const TactileFeatures before = featuresOf(frame, settings);
            const TactileFeatures mirrored = featuresOf(frame.mirrored(), settings);
            const TactileFeatures turned = featuresOf(frame.turned(), settings);
            expectSameShape(mirrored, before);
            expectSameShape(turned, before);
            ASSERT_NEAR(*mirrored.copX_m, -*before.copX_m, 1e-15);
            ASSERT_NEAR(*mirrored.copY_m, *before.copY_m, 1e-15);
            ASSERT_NEAR(*mirrored.cocX_m, -*before.cocX_m, 1e-15);
            ASSERT_NEAR(*mirrored.dzmpY_m, -*before.dzmpY_m, 1e-15);
            ASSERT_NEAR(*mirrored.dzmpX_m, *before.dzmpX_m, 1e-15);
            ASSERT_NEAR(*turned.copX_m, -*before.copY_m, 1e-15);
            ASSERT_NEAR(*turned.copY_m, *before.copX_m, 1e-15);
            ASSERT_NEAR(*turned.cocX_m, -*before.cocY_m, 1e-15);
            ASSERT_NEAR(*turned.dzmpX_m, *before.dzmpY_m, 1e-15);
            ASSERT_NEAR(*turned.dzmpY_m, -*before.dzmpX_m, 1e-15);
            if (!hasClearAxis(before))
                continue;
            ASSERT_NEAR(axisError_rad(*mirrored.alphaZ_rad, -*before.alphaZ_rad), 0.0, 1e-9);
            ASSERT_NEAR(axisError_rad(*turned.alphaZ_rad, *before.alphaZ_rad + kHalfTurn_rad / 2.0), 0.0,
                        1e-9);
        }
    }
}

TEST(FeaturesStability, scaleFromTinyToHugeLoads) {
    std::mt19937 random(36);
    for (FeatureSettings settings : allSettings()) {
        for (int trial = 0; trial < 50; ++trial) {
            const Frame frame = randomFrame(random, kPaperArray, 0.3);
            settings.threshold_N = static_cast<double>(0.2F);
            const TactileFeatures before = featuresOf(frame, settings);
            // Powers of two near 1e-12 and 1e12 change no digit.
            for (const double factor : {0x1p-40, 0x1p40}) {
                settings.threshold_N = static_cast<double>(0.2F) * factor;
                const TactileFeatures after = featuresOf(frame.scaled(static_cast<float>(factor)), settings);
                ASSERT_EQ(after.type, before.type);
                ASSERT_EQ(after.active, before.active);
                ASSERT_EQ(after.force_N, before.force_N * factor);
                ASSERT_EQ(after.copX_m, before.copX_m);
                ASSERT_EQ(after.dzmpX_m, before.dzmpX_m);
                ASSERT_EQ(after.lambda1_m2, before.lambda1_m2);
                ASSERT_EQ(after.lambda2_m2, before.lambda2_m2);
                ASSERT_EQ(after.alphaZ_rad, before.alphaZ_rad);
            }
        }
    }
}

TEST(FeaturesStability, theAngleIsInItsRangeForEveryPairOfTaxels) {
    for (const OrientationMode mode : {OrientationMode::binarised, OrientationMode::weighted}) {
        for (std::size_t i = 0; i < 84; ++i) {
            for (std::size_t j = i + 1; j < 84; ++j) {
                Frame frame;
                frame.load_N[i] = 0.7F;
                frame.load_N[j] = 1.3F;
                const double dx = static_cast<double>(j % 14) - static_cast<double>(i % 14);
                const double dy = static_cast<double>(j / 14) - static_cast<double>(i / 14);
                const TactileFeatures features = featuresOf(frame, {.orientation = mode});
                ASSERT_EQ(features.type, ContactType::edge);
                if (mode == OrientationMode::binarised) {
                    ASSERT_EQ(*features.lambda2_m2, 0.0);
                } else {
                    ASSERT_NEAR(*features.lambda2_m2, 0.0, 1e-16 * *features.lambda1_m2);
                }
                ASSERT_NEAR(*features.lambda1_m2, 0.5 * (dx * dx + dy * dy) * 0.0034 * 0.0034, 1e-15);
                ASSERT_GT(*features.alphaZ_rad, -kHalfTurn_rad / 2.0);
                ASSERT_LE(*features.alphaZ_rad, kHalfTurn_rad / 2.0);
                ASSERT_NEAR(axisError_rad(*features.alphaZ_rad, std::atan2(dy, dx)), 0.0, 1e-12);
            }
        }
    }
}

TEST(FeaturesStability, arraysOfOneTaxelAndOf256By256HaveTheirClosedForms) {
    const TactileFeatures one = featuresOf(block({1, 1, 0.001}, 0, 0, 0, 0, 1.0F));
    EXPECT_EQ(one.type, ContactType::point);
    EXPECT_EQ(*one.copX_m, 0.0);
    EXPECT_EQ(*one.cocY_m, 0.0);
    EXPECT_FALSE(one.alphaZ_rad);

    const ArrayLayout layout{256, 256, 0.001};
    const TactileFeatures all = featuresOf(block(layout, 0, 255, 0, 255, 0.5F));
    EXPECT_EQ(all.force_N, 32768.0);
    EXPECT_FALSE(all.alphaZ_rad);
    EXPECT_NEAR(*all.copX_m, 0.0, 1e-15);
    EXPECT_EQ(*all.cocX_m, 0.0);
    EXPECT_NEAR(*all.lambda1_m2, 65535.0 / 12.0 * 65536.0 / 65535.0 * 1e-6, 1e-15);

    // The lower half: 128 rows from 128 on, centre at row 191.5, which is 64 over the middle.
    const TactileFeatures half = featuresOf(block(layout, 128, 255, 0, 255, 0.5F));
    EXPECT_EQ(half.type, ContactType::edge) << "ratio 65535/16383 is 4.0002";
    EXPECT_DOUBLE_EQ(*half.cocY_m, 0.064);
    EXPECT_NEAR(*half.copY_m, 0.064, 1e-15);
    EXPECT_EQ(*half.alphaZ_rad, 0.0);
    EXPECT_NEAR(*half.lambda1_m2, 65535.0 / 12.0 * 32768.0 / 32767.0 * 1e-6, 1e-15);
    EXPECT_NEAR(*half.lambda2_m2, 16383.0 / 12.0 * 32768.0 / 32767.0 * 1e-6, 1e-15);
}

TEST(FeaturesStability, oneTaxelThatOutweighsAllOthersCancelsNowhere) {
    // Loads 1e12 and two of 1: covariance about the heavy taxel; closed form to first order in 1e-12:
    // denominator F - sum f^2/F = 2 w (1 + ...) with w = 2 the light loads together, so 4.
    Frame frame;
    frame.at(2, 6) = 1e12F;
    frame.at(2, 8) = 1.0F;
    frame.at(4, 6) = 1.0F;
    const TactileFeatures features = featuresOf(frame, {.orientation = OrientationMode::weighted});
    EXPECT_NEAR(*features.lambda1_m2, 4.0 / 4.0 * 0.0034 * 0.0034, 1e-10 * 0.0034 * 0.0034);
    EXPECT_NEAR(*features.lambda2_m2, 4.0 / 4.0 * 0.0034 * 0.0034, 1e-10 * 0.0034 * 0.0034);
    EXPECT_EQ(features.force_N, static_cast<double>(1e12F) + 2.0);
}
