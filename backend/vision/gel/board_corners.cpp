// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/board_corners.h"

#include "backend/core/failure.h"
#include "backend/vision/gel/marker_layout.h"

#include <QCoreApplication>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <utility>

namespace teleta::vision {

namespace {

struct BoardText {
    Q_DECLARE_TR_FUNCTIONS(BoardCorners)
};

constexpr double kBlur_px = 1.5;
constexpr int kApart_px = 7;     ///< side of the window in which one saddle stands
constexpr double kWeakest = 0.1; ///< of the strongest saddle
constexpr int kWindow_px = 4;    ///< half of the one in which a corner is refined
constexpr double kShareOfSquare = 0.4;
constexpr double kLargestWindow_px = 20.0;
/// Over rendered boards with squares of 8 to 25 px the scale was off by 0.002 to 0.011 px at the mean radius
/// of the corners, also without noise, where their scatter about the fit says half of it.
constexpr double kShared_px = 0.01;
constexpr std::size_t kSpare = 4; ///< saddles looked at for each corner

/// Whether the picture around a place looks the same when it is turned by half a turn, as where four squares
/// meet. At the board's rim, where one dark square ends, it does not.
bool looksTurned(const cv::Mat1f& bright, int u, int v) {
    constexpr double kRadius_px = 5.0;
    constexpr int kDirections = 16; ///< of half a turn
    constexpr double kMostDifferent = 0.25;
    float least = bright(v, u);
    float most = least;
    float different = 0.0F;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = std::numbers::pi * i / kDirections;
        const int along = static_cast<int>(std::lround(kRadius_px * std::cos(angle)));
        const int across = static_cast<int>(std::lround(kRadius_px * std::sin(angle)));
        const float one = bright(v + across, u + along);
        const float other = bright(v - across, u - along);
        least = std::min({least, one, other});
        most = std::max({most, one, other});
        different += std::abs(one - other) / static_cast<float>(kDirections);
    }
    return different < static_cast<float>(kMostDifferent) * (most - least);
}

/// Places where the brightness rises along one direction and falls across it, strongest first.
std::vector<cv::Point2f> saddlesOf(const cv::Mat1f& bright, std::size_t most) {
    cv::Mat1f xx, yy, xy;
    cv::Sobel(bright, xx, CV_32F, 2, 0);
    cv::Sobel(bright, yy, CV_32F, 0, 2);
    cv::Sobel(bright, xy, CV_32F, 1, 1);
    cv::Mat1f saddle = xy.mul(xy) - xx.mul(yy);
    cv::Mat1f largest;
    cv::dilate(saddle, largest, cv::Mat::ones(kApart_px, kApart_px, CV_8U));
    double strongest = 0.0;
    cv::minMaxLoc(saddle, nullptr, &strongest);
    const auto weakest = static_cast<float>(kWeakest * strongest);
    std::vector<std::pair<float, cv::Point2f>> found;
    for (int v = kApart_px; v + kApart_px < saddle.rows; ++v)
        for (int u = kApart_px; u + kApart_px < saddle.cols; ++u)
            if (saddle(v, u) >= largest(v, u) && saddle(v, u) > weakest && looksTurned(bright, u, v))
                found.emplace_back(saddle(v, u), cv::Point2f(static_cast<float>(u), static_cast<float>(v)));
    std::ranges::sort(found, std::ranges::greater(), &std::pair<float, cv::Point2f>::first);
    std::vector<cv::Point2f> places;
    for (std::size_t i = 0; i < std::min(found.size(), most); ++i)
        places.push_back(found[i].second);
    return places;
}

std::size_t numbered(const std::vector<GridPlace>& grid) {
    return static_cast<std::size_t>(
        std::ranges::count_if(grid, [](const GridPlace& place) { return place.row >= 0; }));
}

/// Again, with as much of the edges as the smallest square has: more than kWindow_px where squares are large.
void refineInSquares(const cv::Mat1f& bright, std::vector<PlanePair>& pairs) {
    double smallest_px = 0.0;
    std::vector<cv::Point2f> places;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        places.emplace_back(static_cast<float>(pairs[i].pixel.x()), static_cast<float>(pairs[i].pixel.y()));
        for (std::size_t j = 0; j < i; ++j) {
            const double apart_px = (pairs[i].pixel - pairs[j].pixel).norm();
            smallest_px = smallest_px > 0.0 ? std::min(smallest_px, apart_px) : apart_px;
        }
    }
    const int window_px = static_cast<int>(std::min(kShareOfSquare * smallest_px, kLargestWindow_px));
    if (window_px <= kWindow_px)
        return;
    cv::cornerSubPix(bright, places, {window_px, window_px}, {-1, -1},
                     {cv::TermCriteria::EPS + cv::TermCriteria::MAX_ITER, 50, 1e-3});
    for (std::size_t i = 0; i < pairs.size(); ++i)
        pairs[i].pixel = {static_cast<double>(places[i].x), static_cast<double>(places[i].y)};
}

/// The corners in a picture at one size; some may be missing.
std::vector<PlanePair> cornersAt(const cv::Mat1b& picture, const BoardSize& board) {
    const auto wanted = static_cast<std::size_t>(board.rows) * static_cast<std::size_t>(board.columns);
    // Edges as sharp as a pixel would draw corners to the middle of pixels.
    cv::Mat1f bright;
    picture.convertTo(bright, CV_32F);
    cv::GaussianBlur(bright, bright, {}, kBlur_px);
    std::vector<cv::Point2f> saddles = saddlesOf(bright, kSpare * wanted);
    if (!saddles.empty())
        cv::cornerSubPix(bright, saddles, {kWindow_px, kWindow_px}, {-1, -1},
                         {cv::TermCriteria::EPS + cv::TermCriteria::MAX_ITER, 50, 1e-3});
    std::vector<Eigen::Vector2d> corners_px;
    for (const cv::Point2f& saddle : saddles)
        corners_px.emplace_back(static_cast<double>(saddle.x), static_cast<double>(saddle.y));
    std::vector<GridPlace> best(corners_px.size());
    for (const auto& [rows, columns] : {std::pair{board.rows, board.columns}, {board.columns, board.rows}}) {
        std::vector<GridPlace> grid = gridPlaces(corners_px, MarkerGrid::rectangular, rows, columns);
        if (numbered(grid) > numbered(best))
            best = std::move(grid);
    }
    std::vector<PlanePair> pairs;
    for (std::size_t i = 0; i < best.size(); ++i)
        if (best[i].row >= 0)
            pairs.push_back({corners_px[i], board.square_m * Eigen::Vector2d(best[i].column, best[i].row)});
    refineInSquares(bright, pairs);
    return pairs;
}

} // namespace

core::Expected<BoardCorners> boardCorners(const cv::Mat1b& picture, const BoardSize& board) {
    const auto wanted = static_cast<std::size_t>(board.rows) * static_cast<std::size_t>(board.columns);
    std::size_t most = 0;
    cv::Mat1b smaller = picture;
    for (double step = 1.0; smaller.rows > 3 * kApart_px && smaller.cols > 3 * kApart_px; step *= 2.0) {
        BoardCorners found{cornersAt(smaller, board), step * kShared_px};
        if (found.pairs.size() == wanted) {
            // Pixel 0 of the smaller picture lies between the first pixels of the larger one.
            for (PlanePair& pair : found.pairs)
                pair.pixel = step * (pair.pixel.array() + 0.5) - 0.5;
            return found;
        }
        most = std::max(most, found.pairs.size());
        cv::Mat1b half;
        // Of an odd number of rows or columns the last one is left out: each pixel is that of four.
        cv::resize(smaller(cv::Rect(0, 0, smaller.cols / 2 * 2, smaller.rows / 2 * 2)), half, {}, 0.5, 0.5,
                   cv::INTER_AREA);
        smaller = half;
    }
    return core::refused(
        BoardText::tr("only %1 of the %2 corners of the chessboard are found").arg(most).arg(wanted),
        BoardText::tr("a whole chessboard of %1 x %2 inner corners, in focus and evenly lit")
            .arg(board.columns)
            .arg(board.rows));
}

} // namespace teleta::vision
