// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/gel/marker_gel_file.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace teleta::vision {

/// Place of a marker in its grid.
struct GridPlace {
    int row = -1; ///< along v, from the top; -1: none
    int column = -1;
};

/// Median distance of a place to its nearest one; 0 for fewer than two. Thread: any (pure).
[[nodiscard]] double nearestDistance_px(std::span<const Eigen::Vector2d> places_px);

/// Indices of the neighbours of each place: the 8 nearest of those within 1.6 times the
/// local distance, nearest first. Thread: any (pure).
[[nodiscard]] std::vector<std::vector<std::size_t>>
markerNeighbours(std::span<const Eigen::Vector2d> places_px);

/// Numbers places that form a bent and incomplete grid, from its middle outwards: the next place is expected
/// where the last step of its row, or else of the whole grid, leads, within 0.35 steps. rows, columns: of a
/// rectangular grid; what lies outside the part of the grid that has most places, gets none. A free grid has
/// no places. Rows are those that run more along u than along v; of a hexagonal grid every second row is half
/// a step further right. Thread: any (pure).
[[nodiscard]] std::vector<GridPlace> gridPlaces(std::span<const Eigen::Vector2d> places_px, MarkerGrid grid,
                                                int rows, int columns);

} // namespace teleta::vision
