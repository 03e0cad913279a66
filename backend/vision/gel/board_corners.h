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

struct BoardCorners {
    std::vector<PlanePair> pairs;
    /// What corners may be wrong by together, for fitHomography(). The errors of a printed board and of a
    /// lens are not in it.
    double shared_px = 0.0;
};

/// Finds the inner corners of a chessboard: saddles of the brightness, refined to parts of a pixel where the
/// gradients around them meet, and numbered as a grid. If not all are found, as in a large picture that is
/// out of focus, it looks again in the picture at half its size, and so on. The board may lie in any
/// direction. Places count from one of its corners. picture: squares of at least 8 px. Error: refused: not
/// each corner of a grid of this size is found. Thread: any (pure).
[[nodiscard]] core::Expected<BoardCorners> boardCorners(const cv::Mat1b& picture, const BoardSize& board);

} // namespace teleta::vision
