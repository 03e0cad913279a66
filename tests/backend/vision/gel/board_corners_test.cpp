// SPDX-License-Identifier: GPL-3.0-or-later
// Chessboards that are drawn from a known homography.
#include "backend/vision/gel/board_corners.h"
#include "tests/backend/vision/gel/drawn_board.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
            ASSERT_EQ(pairs->size(), 35U);
            double squared = 0.0;
            for (const PlanePair& pair : *pairs) {
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
            const auto fit = fitHomography(*pairs);
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

TEST(BoardCorners, refuseAPictureWithoutTheWholeBoard) {
    EXPECT_FALSE(boardCorners(cv::Mat1b(240, 320, std::uint8_t{128}), kBoard));
    EXPECT_FALSE(boardCorners(cv::Mat1b(4, 4, std::uint8_t{0}), kBoard));
    EXPECT_FALSE(boardCorners(cv::Mat1b(), kBoard));
    const cv::Mat1b whole = test::drawnBoard(seenAt(0.1, 0.0), kBoard, 2.0);
    const auto larger = boardCorners(whole, {.columns = 9, .rows = 6, .square_m = 0.002});
    ASSERT_FALSE(larger);
    EXPECT_EQ(larger.error().kind, core::ErrorKind::refused);
    cv::Mat1b covered = whole.clone();
    covered(cv::Rect(150, 0, 170, 240)).setTo(200);
    EXPECT_FALSE(boardCorners(covered, kBoard));
}

} // namespace
} // namespace teleta::vision
