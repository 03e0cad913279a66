// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/gel/plane_fit.h"

#include <opencv2/core.hpp>

#include <vector>

namespace teleta::vision {

/// Corners at which four squares of a chessboard meet: as many along its longer rows and across them.
struct BoardSize {
    int columns = 0;
    int rows = 0;
    double square_m = 0.0; ///< side of a square
};

/// Finds the inner corners of a chessboard: saddles of the brightness, refined to parts of a pixel where the
/// gradients around them meet, and numbered as a grid. The board may lie in any direction. Places count from
/// one of its corners. picture: squares of at least 8 px. Error: refused: no grid of this size, or not each
/// of its corners, is in the picture. Thread: any (pure).
[[nodiscard]] core::Expected<std::vector<PlanePair>> boardCorners(const cv::Mat1b& picture,
                                                                  const BoardSize& board);

} // namespace teleta::vision
