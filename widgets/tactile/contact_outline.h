// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace teleta::tactile {

/// A corner of an outline on the grid between taxels: taxel (row, column) covers column..column+1,
/// row..row+1. inColumn, inRow: direction in which the corner moves when the outline is drawn one unit
/// further inside.
struct OutlineCorner {
    int column = 0, row = 0;
    int inColumn = 0, inRow = 0;

    bool operator==(const OutlineCorner&) const = default;
};

/// A closed loop of corners with the region on its left (columns to the right, rows up); holes run the other
/// way.
using OutlineLoop = std::vector<OutlineCorner>;

/// Taxel rows and columns of a bounding box, inclusive.
struct TaxelBox {
    int minRow = 0, maxRow = 0, minColumn = 0, maxColumn = 0;
};

/// Outlines of the taxels with one label. Taxels that touch only at a corner get separate loops. labels: rows
/// x columns, row-major. box: must contain all taxels of the region and lie inside the array. Thread: any
/// (pure).
[[nodiscard]] std::vector<OutlineLoop> traceOutline(std::span<const std::int32_t> labels, int columns,
                                                    std::int32_t region, const TaxelBox& box);

} // namespace teleta::tactile
