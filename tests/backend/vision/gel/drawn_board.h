// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/gel/board_corners.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace teleta::test {

/// A chessboard whose first inner corner is at the origin of the plane, with a white margin.
/// toPixel: from place (m) to pixel. noise: standard deviation of a pixel, in grey levels.
inline cv::Mat1b drawnBoard(const Eigen::Matrix3d& toPixel, const vision::BoardSize& board, double noise,
                            const cv::Size& size = {320, 240}, unsigned seed = 3) {
    constexpr int kSub = 5; ///< points of a pixel along each axis
    const Eigen::Matrix3d toPlace = toPixel.inverse();
    std::mt19937 random(seed);
    std::normal_distribution<double> error(0.0, 1.0);
    cv::Mat1b picture(size);
    for (int v = 0; v < picture.rows; ++v)
        for (int u = 0; u < picture.cols; ++u) {
            double level = 0.0;
            for (int part = 0; part < kSub * kSub; ++part) {
                const Eigen::Vector3d pixel(u + (part % kSub + 0.5) / kSub - 0.5,
                                            v + (part / kSub + 0.5) / kSub - 0.5, 1.0);
                const Eigen::Vector2d square = (toPlace * pixel).hnormalized() / board.square_m;
                const int column = static_cast<int>(std::floor(square.x()));
                const int row = static_cast<int>(std::floor(square.y()));
                const bool isOnBoard =
                    column >= -1 && column < board.columns && row >= -1 && row < board.rows;
                level += isOnBoard && (column + row) % 2 == 0 ? 40.0 : 200.0;
            }
            picture(v, u) = static_cast<std::uint8_t>(
                std::clamp(level / (kSub * kSub) + noise * error(random) + 0.5, 0.0, 255.0));
        }
    return picture;
}

} // namespace teleta::test
