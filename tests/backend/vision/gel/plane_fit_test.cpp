// SPDX-License-Identifier: GPL-3.0-or-later
// The plane of a gel from points of a flat pattern, against closed forms and OpenCV's homography.
#include "backend/vision/gel/plane_fit.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#ifdef TELETA_HAS_OPENCV
#include <opencv2/calib3d.hpp>
#endif

#include <cmath>
#include <random>
#include <vector>

namespace teleta::vision {
namespace {

/// From place (m) to pixel: a camera that looks at the plane askew.
Eigen::Matrix3d askew() {
    Eigen::Matrix3d matrix;
    matrix << 14'000.0, 900.0, 60.0, -700.0, 13'500.0, 40.0, 2.0, 5.0, 1.0;
    return matrix;
}

std::vector<PlanePair> gridSeenBy(const Eigen::Matrix3d& toPixel, int columns, int rows,
                                  double noise_px = 0.0, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<PlanePair> pairs;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            PlanePair pair;
            pair.place_m = {0.002 * column, 0.002 * row};
            pair.pixel = (toPixel * pair.place_m.homogeneous()).hnormalized();
            pair.pixel += noise_px * Eigen::Vector2d(noise(random), noise(random));
            pairs.push_back(pair);
        }
    return pairs;
}

/// Distance on the plane of two pixels, which does not depend on where the plane has its origin.
double distance_m(const Eigen::Matrix3d& toPlace, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return ((toPlace * a.homogeneous()).hnormalized() - (toPlace * b.homogeneous()).hnormalized()).norm();
}

TEST(PlaneFit, findsTheHomographyOfExactPointsInClosedForm) {
    const Eigen::Matrix3d truth = askew().inverse();
    const auto fit = fitHomography(gridSeenBy(askew(), 7, 5));
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_LT(fit->rms_px, 1e-6);
    EXPECT_EQ(fit->kept, 35U);
    const Eigen::Vector2d a(70.0, 60.0);
    for (const Eigen::Vector2d& b : {Eigen::Vector2d(200.0, 60.0), Eigen::Vector2d(70.0, 150.0)})
        EXPECT_NEAR(distance_m(fit->homography, a, b), distance_m(truth, a, b), 1e-10);
    // Root of the area of a pixel in the middle, by the derivative of the true one.
    const Eigen::Vector2d middle = (askew() * Eigen::Vector3d(0.006, 0.004, 1.0)).hnormalized();
    constexpr double kStep = 1e-3;
    const auto at = [&](double u, double v) -> Eigen::Vector2d {
        return (truth * (middle + Eigen::Vector2d(u, v)).homogeneous()).hnormalized();
    };
    const Eigen::Vector2d u = (at(kStep, 0.0) - at(-kStep, 0.0)) / (2.0 * kStep);
    const Eigen::Vector2d v = (at(0.0, kStep) - at(0.0, -kStep)) / (2.0 * kStep);
    EXPECT_NEAR(fit->scale_mPerPx, std::sqrt(u.x() * v.y() - u.y() * v.x()), 1e-11);
    // There x runs along u, and the place is what the scale alone gives.
    const Eigen::Vector2d place = (fit->homography * middle.homogeneous()).hnormalized();
    EXPECT_NEAR((place - fit->scale_mPerPx * middle).norm(), 0.0, 1e-10);
}

#ifdef TELETA_HAS_OPENCV
TEST(PlaneFit, isThatOfOpenCv) {
    const auto pairs = gridSeenBy(askew(), 9, 6, 0.2, 7);
    std::vector<cv::Point2d> pixels, places;
    for (const PlanePair& pair : pairs) {
        pixels.emplace_back(pair.pixel.x(), pair.pixel.y());
        places.emplace_back(pair.place_m.x(), pair.place_m.y());
    }
    const cv::Mat peer = cv::findHomography(places, pixels); // least squares in the picture
    Eigen::Matrix3d toPixel;
    for (int i = 0; i < 9; ++i)
        toPixel(i / 3, i % 3) = peer.at<double>(i / 3, i % 3);
    const Eigen::Matrix3d toPlace = toPixel.inverse();
    const auto fit = fitHomography(pairs);
    ASSERT_TRUE(fit) << core::describe(fit.error());
    const Eigen::Vector2d a = pairs.front().pixel;
    for (const PlanePair& pair : pairs)
        EXPECT_NEAR(distance_m(fit->homography, a, pair.pixel), distance_m(toPlace, a, pair.pixel), 6e-6)
            << "Tukey's weights differ a little from least squares";
}
#endif

TEST(PlaneFit, leavesOutPointsThatAreWrong) {
    auto pairs = gridSeenBy(askew(), 7, 5, 0.05);
    for (const std::size_t wrong : {2U, 9U, 17U, 30U})
        pairs[wrong].pixel += Eigen::Vector2d(12.0, -7.0);
    const auto fit = fitHomography(pairs);
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_LT(fit->rms_px, 0.15);
    EXPECT_LE(fit->kept, 31U);
    const Eigen::Vector2d a(70.0, 60.0), b(200.0, 150.0);
    EXPECT_NEAR(distance_m(fit->homography, a, b), distance_m(askew().inverse(), a, b), 1e-5);
}

/// The scale is off by about its standard deviation: its normalised error has the variance 1.
TEST(PlaneFit, theStandardDeviationOfTheScaleIsRight) {
    const auto exact = fitHomography(gridSeenBy(askew(), 7, 5));
    ASSERT_TRUE(exact);
    double squared = 0.0;
    double squaredScale = 0.0;
    constexpr int kRuns = 200;
    Eigen::Matrix3d plain = Eigen::Matrix3d::Identity() * 15'000.0;
    plain(2, 2) = 1.0;
    for (int run = 0; run < kRuns; ++run) {
        const auto fit = fitHomography(gridSeenBy(askew(), 7, 5, 0.1, static_cast<unsigned>(run)));
        ASSERT_TRUE(fit);
        squared += std::pow((fit->scale_mPerPx - exact->scale_mPerPx) / fit->scaleError_mPerPx, 2);
        const auto scale = fitScale(gridSeenBy(plain, 7, 5, 0.1, static_cast<unsigned>(run)));
        ASSERT_TRUE(scale);
        squaredScale += std::pow((scale->scale_mPerPx - 1.0 / 15'000.0) / scale->scaleError_mPerPx, 2);
    }
    EXPECT_GT(squared / kRuns, 0.7);
    EXPECT_LT(squared / kRuns, 1.5);
    EXPECT_GT(squaredScale / kRuns, 0.7);
    EXPECT_LT(squaredScale / kRuns, 1.5);
}

TEST(PlaneFit, findsOneScaleOfATurnedPattern) {
    Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
    turned.topLeftCorner<2, 2>() = 16'000.0 * Eigen::Rotation2Dd(0.3).toRotationMatrix();
    turned.topRightCorner<2, 1>() = Eigen::Vector2d(100.0, 50.0);
    const auto fit = fitScale(gridSeenBy(turned, 4, 3));
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_TRUE(fit->isScale);
    EXPECT_NEAR(fit->scale_mPerPx, 1.0 / 16'000.0, 1e-12);
    EXPECT_EQ(fit->homography(0, 0), fit->scale_mPerPx);
}

TEST(PlaneFit, refusesWhatShowsNoPlane) {
    for (const auto& pairs :
         {gridSeenBy(askew(), 1, 1), gridSeenBy(askew(), 8, 1), gridSeenBy(askew(), 1, 8)}) {
        EXPECT_EQ(fitHomography(pairs).error().kind, core::ErrorKind::refused);
        EXPECT_EQ(fitScale(pairs).error().kind, core::ErrorKind::refused);
    }
    EXPECT_FALSE(fitHomography({}));
    auto mirrored = gridSeenBy(askew(), 5, 5);
    for (PlanePair& pair : mirrored)
        pair.place_m.x() = -pair.place_m.x();
    EXPECT_FALSE(fitHomography(mirrored));
    auto same = gridSeenBy(askew(), 5, 5);
    for (PlanePair& pair : same)
        pair.pixel = {10.0, 10.0};
    EXPECT_FALSE(fitHomography(same));
}

TEST(PlaneFit, takesTheScaleOfARuler) {
    // 3-4-5: 500 px for 20 mm; each end is read within half a pixel along an axis.
    const RulerReading reading{{100.0, 50.0}, {400.0, 450.0}, 0.02};
    const auto fit = fitRuler(std::vector{reading});
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_NEAR(fit->scale_mPerPx, 4e-5, 1e-15);
    EXPECT_NEAR(fit->scaleError_mPerPx, 4e-5 * std::sqrt(2.0) * 0.5 / 500.0, 1e-15);
    // Two that differ by 10 px: k = (500 + 510) / 2 px for 20 mm.
    const auto two = fitRuler(std::vector{reading, RulerReading{{0.0, 0.0}, {510.0, 0.0}, 0.02}});
    ASSERT_TRUE(two);
    EXPECT_NEAR(two->scale_mPerPx, 0.02 / 505.0, 1e-15);
    EXPECT_NEAR(two->scaleError_mPerPx, 0.02 / 505.0 * std::sqrt(50.0) / std::sqrt(2.0) / 505.0, 1e-12);
    EXPECT_TRUE(std::isnan(fit->rms_px));
    EXPECT_NEAR(two->rms_px, 5.0, 1e-9);
    // Half of the length by mistake.
    const auto wrong = fitRuler(std::vector{reading, RulerReading{{0.0, 0.0}, {500.0, 0.0}, 0.01}});
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().message.find("contradict"), std::string::npos);
    EXPECT_FALSE(fitRuler({}));
    EXPECT_FALSE(fitRuler(std::vector{RulerReading{{5.0, 5.0}, {5.0, 5.0}, 0.02}}));
    EXPECT_FALSE(fitRuler(std::vector{RulerReading{{5.0, 5.0}, {500.0, 5.0}, 0.0}}));
}

} // namespace
} // namespace teleta::vision
