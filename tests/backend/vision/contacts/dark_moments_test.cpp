// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/dark_moments.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace teleta::vision {
namespace {

constexpr int kWidth_px = 97;
constexpr int kHeight_px = 71;

struct Plain {
    double sum = 0.0;
    Eigen::Vector2d sum_px = Eigen::Vector2d::Zero();
    double darkest = 0.0;
};

/// The sums as they are defined, over all pixels of the picture.
Plain plainMoments(const cv::Mat1b& frame, const cv::Mat1b& hidden, const Eigen::Matrix2d& metric, int stride,
                   const Eigen::Vector2d& centre_px, double ground) {
    Plain plain;
    for (int v = 0; v < frame.rows; v += stride) {
        for (int u = 0; u < frame.cols; u += stride) {
            const Eigen::Vector2d e = Eigen::Vector2d(u, v) - centre_px;
            const double q = e.dot(metric * e);
            const double dark = hidden(v, u) != 0 ? 0.0 : std::max(0.0, ground - frame(v, u));
            if (q >= 1.0)
                continue;
            plain.sum += (1.0 - q) * (1.0 - q) * dark;
            plain.sum_px += (1.0 - q) * (1.0 - q) * dark * e;
            // At the very border rounding decides whether a pixel is inside.
            if (q < 1.0 - 1e-4)
                plain.darkest = std::max(plain.darkest, dark);
        }
    }
    return plain;
}

Eigen::Matrix2d metricOf(double long_px, double short_px, double angle_rad) {
    const Eigen::Rotation2Dd turn(angle_rad);
    return turn * Eigen::Vector2d(1.0 / (long_px * long_px), 1.0 / (short_px * short_px)).asDiagonal() *
           turn.inverse();
}

} // namespace

TEST(DarkMoments, areThePlainSumsForAnyWindowPlaceAndMask) {
    std::mt19937 engine(5);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    cv::Mat1b frame(kHeight_px, kWidth_px);
    cv::Mat1b hidden(kHeight_px, kWidth_px, std::uint8_t{0});
    for (std::uint8_t& level : frame)
        level = static_cast<std::uint8_t>(uniform(0.0, 256.0));
    hidden(cv::Rect(60, 0, 37, 20)) = 255;
    for (int i = 0; i < 3000; ++i) {
        const double short_px = uniform(2.5, 14.0);
        const Eigen::Matrix2d metric =
            metricOf(short_px * uniform(1.0, 4.0), short_px, uniform(0.0, std::numbers::pi));
        const int stride = 1 + i % 4;
        const double ground = static_cast<double>(static_cast<float>(uniform(20.0, 255.0)));
        // Also beyond the edges of the picture.
        const Eigen::Vector2d centre_px(uniform(-10.0, kWidth_px + 10.0), uniform(-10.0, kHeight_px + 10.0));
        const Plain plain = plainMoments(frame, hidden, metric, stride, centre_px, ground);
        const DarkMoments moments =
            darkMoments(frame, hidden, DotWindow(metric, stride), centre_px, static_cast<float>(ground));
        const double rounding = 1e-4 * std::max(1.0, plain.sum);
        EXPECT_NEAR(moments.sum, plain.sum, rounding) << i;
        EXPECT_NEAR(moments.sum_px.x(), plain.sum_px.x(), 50.0 * rounding) << i;
        EXPECT_NEAR(moments.sum_px.y(), plain.sum_px.y(), 50.0 * rounding) << i;
        EXPECT_GE(moments.darkest, plain.darkest - 1e-3) << i;
        EXPECT_LE(moments.darkest, ground) << i;
    }
}

TEST(DarkMoments, needNoMaskWhereNothingIsHidden) {
    cv::Mat1b frame(kHeight_px, kWidth_px, std::uint8_t{200});
    cv::circle(frame, {40, 30}, 5, 40, cv::FILLED);
    const DotWindow window(metricOf(12.0, 9.0, 0.4), 1);
    const DarkMoments with =
        darkMoments(frame, cv::Mat1b(frame.size(), std::uint8_t{0}), window, {41.3, 29.6}, 150.0F);
    const DarkMoments without = darkMoments(frame, {}, window, {41.3, 29.6}, 150.0F);
    EXPECT_EQ(with.sum, without.sum);
    EXPECT_EQ(with.sum_px, without.sum_px);
    EXPECT_EQ(without.darkest, 110.0F);
}

TEST(DarkMoments, ofAWindowFarOutsideThePictureAreZero) {
    const cv::Mat1b frame(kHeight_px, kWidth_px, std::uint8_t{0});
    const DotWindow window(metricOf(12.0, 9.0, 0.4), 2);
    for (const Eigen::Vector2d& centre_px :
         {Eigen::Vector2d(-1e9, 10.0), Eigen::Vector2d(1e300, -1e300), Eigen::Vector2d(10.0, 1e12)}) {
        prefetch(frame, window, centre_px);
        EXPECT_EQ(darkMoments(frame, {}, window, centre_px, 200.0F).sum, 0.0F);
    }
}

} // namespace teleta::vision
