// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/drawn_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::view3d {

namespace {

int blocksIn(int count, int block) {
    return (count + block - 1) / block;
}

} // namespace

DrawnGrid::DrawnGrid(const core::ArrayLayout& layout)
    : m_layout(layout)
    , m_block(blocksIn(std::max(layout.rows, layout.columns), kMaximumSide))
    , m_rows(blocksIn(layout.rows, m_block))
    , m_columns(blocksIn(layout.columns, m_block)) {
}

DrawnGrid::Edges DrawnGrid::edges(int row, int column) const {
    const int lastColumn = std::min((column + 1) * m_block, m_layout.columns) - 1;
    const int lastRow = std::min((row + 1) * m_block, m_layout.rows) - 1;
    return {.x0_m = m_layout.x_m(column * m_block - 0.5),
            .x1_m = m_layout.x_m(lastColumn + 0.5),
            .y0_m = m_layout.y_m(row * m_block - 0.5),
            .y1_m = m_layout.y_m(lastRow + 0.5)};
}

void DrawnGrid::pool(std::span<const float> load_N, std::span<const std::uint8_t> dead,
                     std::span<float> cell_N) const {
    std::fill(cell_N.begin(), cell_N.end(), std::numeric_limits<float>::quiet_NaN());
    std::size_t taxel = 0;
    for (int row = 0; row < m_layout.rows; ++row) {
        for (int column = 0; column < m_layout.columns; ++column, ++taxel) {
            const float load = load_N[taxel];
            if (!std::isfinite(load) || (!dead.empty() && dead[taxel] != 0))
                continue;
            float& cell = cell_N[cellOf(row, column)];
            const float usable = std::max(load, 0.0F);
            cell = std::isnan(cell) ? usable : std::max(cell, usable);
        }
    }
}

} // namespace teleta::view3d
