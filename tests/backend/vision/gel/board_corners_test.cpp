// SPDX-License-Identifier: GPL-3.0-or-later
// Chessboards that are drawn from a known homography.
#include "backend/vision/gel/board_corners.h"
#include "tests/backend/vision/gel/drawn_board.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace teleta::vision {
namespace {

constexpr BoardSize kBoard{.columns = 7, .rows = 5, .square_m = 0.002};

/// From place (m) to pixel: turned by an angle, and seen askew.
Eigen::Matrix3d seenAt(double turn_rad, double tilt) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix.topLeftCorner<2, 2>() = 11'000.0 * Eigen::Rotation2Dd(turn_rad).toRotationMatrix();
    matrix(2, 0) = tilt;
    matrix(2, 1) = -0.5 * tilt;
    const Eigen::Vector2d middle =
        (matrix * Eigen::Vector3d(0.5 * 6 * 0.002, 0.5 * 4 * 0.002, 1.0)).hnormalized();
    Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
    shift.topRightCorner<2, 1>() = Eigen::Vector2d(161.3, 119.6) - middle;
    return shift * matrix;
}

TEST(BoardCorners, areFoundWhereTheHomographyHasThem) {
    for (const double turn_rad : {0.0, 0.25, -0.4, 1.5, 3.0}) {
        for (const double tilt : {0.0, 9.0}) {
            const Eigen::Matrix3d toPixel = seenAt(turn_rad, tilt);
            const auto pairs = boardCorners(test::drawnBoard(toPixel, kBoard, 2.0), kBoard);
            ASSERT_TRUE(pairs) << turn_rad << ' ' << core::describe(pairs.error());
            ASSERT_EQ(pairs->pairs.size(), 35U);
            double squared = 0.0;
            for (const PlanePair& pair : pairs->pairs) {
                double nearest = std::numeric_limits<double>::infinity();
                for (int row = 0; row < kBoard.rows; ++row)
                    for (int column = 0; column < kBoard.columns; ++column)
                        nearest = std::min(
                            nearest,
                            ((toPixel * Eigen::Vector3d(0.002 * column, 0.002 * row, 1.0)).hnormalized() -
                             pair.pixel)
                                .norm());
                squared += nearest * nearest;
            }
            EXPECT_LT(std::sqrt(squared / 35.0), 0.15) << turn_rad << ' ' << tilt;
            // Whatever corner the grid counts from, lengths on the plane are those of the board.
            const auto fit = fitHomography(pairs->pairs);
            ASSERT_TRUE(fit) << core::describe(fit.error());
            const Eigen::Matrix3d truth = toPixel.inverse();
            const Eigen::Vector2d a(110.0, 90.0), b(210.0, 150.0);
            const auto length = [&](const Eigen::Matrix3d& plane) {
                return ((plane * a.homogeneous()).hnormalized() - (plane * b.homogeneous()).hnormalized())
                    .norm();
            };
            EXPECT_NEAR(length(fit->homography) / length(truth), 1.0, 2e-3) << turn_rad << ' ' << tilt;
            EXPECT_LT(fit->rms_px, 0.15);
        }
    }
}

/// A board of 7 x 5 corners somewhere in a picture that it fills, its squares side_px wide in the middle.
Eigen::Matrix3d somewhere(double side_px, double tilt, std::mt19937& random) {
    std::uniform_real_distribution<double> share(-0.5, 0.5);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix.topLeftCorner<2, 2>() =
        side_px / 0.002 * Eigen::Rotation2Dd(6.0 * share(random)).toRotationMatrix();
    matrix(2, 0) = 2.0 * tilt * share(random);
    matrix(2, 1) = 2.0 * tilt * share(random);
    const Eigen::Vector2d middle = (matrix * Eigen::Vector3d(0.006, 0.004, 1.0)).hnormalized();
    Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
    shift.topRightCorner<2, 1>() =
        Eigen::Vector2d::Constant(5.5 * side_px) + Eigen::Vector2d(share(random), share(random)) - middle;
    return shift * matrix;
}

/// Root of the area of a pixel at the middle of the pattern, by the derivative of the true homography.
double scaleOf(const Eigen::Matrix3d& toPixel) {
    constexpr double kStep_m = 1e-7;
    const auto at = [&](double x_m, double y_m) -> Eigen::Vector2d {
        return (toPixel * Eigen::Vector3d(0.006 + x_m, 0.004 + y_m, 1.0)).hnormalized();
    };
    const Eigen::Vector2d x = (at(kStep_m, 0.0) - at(-kStep_m, 0.0)) / (2.0 * kStep_m);
    const Eigen::Vector2d y = (at(0.0, kStep_m) - at(0.0, -kStep_m)) / (2.0 * kStep_m);
    return 1.0 / std::sqrt(x.x() * y.y() - x.y() * y.x());
}

/// Its error over many boards is as large as its standard deviation says, or somewhat smaller.
TEST(BoardCorners, theStandardDeviationOfTheScaleIsHonest) {
    constexpr unsigned kBoards = 12;
    for (const double side_px : {8.0, 10.0, 12.0, 16.0, 20.0, 25.0}) {
        double squared = 0.0;
        double largest = 0.0;
        int boards = 0;
        for (const double tilt : {0.0, 9.0})
            for (const double noise : {0.0, 6.0})
                for (unsigned seed = 1; seed <= kBoards; ++seed) {
                    std::mt19937 random(seed);
                    const Eigen::Matrix3d toPixel = somewhere(side_px, tilt, random);
                    const int side = static_cast<int>(11.0 * side_px);
                    const auto found =
                        boardCorners(test::drawnBoard(toPixel, kBoard, noise, {side, side}, seed), kBoard);
                    ASSERT_TRUE(found) << side_px << ' ' << core::describe(found.error());
                    const auto fit = fitHomography(found->pairs, found->shared_px);
                    ASSERT_TRUE(fit) << core::describe(fit.error());
                    const double error = (fit->scale_mPerPx - scaleOf(toPixel)) / fit->scaleError_mPerPx;
                    squared += error * error;
                    largest = std::max(largest, std::abs(error));
                    ++boards;
                }
        EXPECT_LT(std::sqrt(squared / boards), 1.0) << side_px;
        EXPECT_GT(std::sqrt(squared / boards), 0.1) << side_px;
        EXPECT_LT(largest, 3.0) << side_px;
    }
}

/// Squares of 80 px, and edges that are 30 px wide.
TEST(BoardCorners, areFoundInALargePictureThatIsOutOfFocus) {
    std::mt19937 random(1);
    const Eigen::Matrix3d toPixel = somewhere(80.0, 4.0, random);
    cv::Mat1b picture = test::drawnBoard(toPixel, kBoard, 0.0, {881, 879});
    cv::GaussianBlur(picture, picture, {}, 12.0);
    const auto found = boardCorners(picture, kBoard);
    ASSERT_TRUE(found) << core::describe(found.error());
    EXPECT_GT(found->shared_px, 0.015) << "they are found in a smaller picture";
    const auto fit = fitHomography(found->pairs, found->shared_px);
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_NEAR(fit->scale_mPerPx / scaleOf(toPixel), 1.0, 1e-3);
    EXPECT_LT(std::abs(fit->scale_mPerPx - scaleOf(toPixel)), 3.0 * fit->scaleError_mPerPx);
    // Where the truth has them: a shift of half a pixel by the smaller picture would show.
    for (const PlanePair& pair : found->pairs) {
        double nearest = std::numeric_limits<double>::infinity();
        for (int row = 0; row < kBoard.rows; ++row)
            for (int column = 0; column < kBoard.columns; ++column)
                nearest = std::min(
                    nearest,
                    ((toPixel * Eigen::Vector3d(0.002 * column, 0.002 * row, 1.0)).hnormalized() - pair.pixel)
                        .norm());
        EXPECT_LT(nearest, 0.5);
    }
}

TEST(BoardCorners, refuseAPictureWithoutTheWholeBoard) {
    EXPECT_FALSE(boardCorners(cv::Mat1b(240, 320, std::uint8_t{128}), kBoard));
    EXPECT_FALSE(boardCorners(cv::Mat1b(4, 4, std::uint8_t{0}), kBoard));
    EXPECT_FALSE(boardCorners(cv::Mat1b(), kBoard));
    const cv::Mat1b whole = test::drawnBoard(seenAt(0.1, 0.0), kBoard, 2.0);
    const auto larger = boardCorners(whole, {.columns = 9, .rows = 6, .square_m = 0.002});
    ASSERT_FALSE(larger);
    EXPECT_NE(larger.error().message.find("found"), std::string::npos);
    EXPECT_EQ(larger.error().kind, core::ErrorKind::refused);
    cv::Mat1b covered = whole.clone();
    covered(cv::Rect(150, 0, 170, 240)).setTo(200);
    EXPECT_FALSE(boardCorners(covered, kBoard));
}

} // namespace
} // namespace teleta::vision
