// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace teleta::view3d {

/// The cells drawn for an array: its taxels, or square blocks of taxels when there are too many to draw at
/// the screen's rate. A block shows its largest load, so that no peak is lost. Thread: any (pure).
class DrawnGrid {
public:
    static constexpr int kMaximumSide = 128;

    DrawnGrid() = default;
    explicit DrawnGrid(const core::ArrayLayout& layout);

    [[nodiscard]] int rows() const { return m_rows; }
    [[nodiscard]] int columns() const { return m_columns; }
    /// Taxels per side of a cell.
    [[nodiscard]] int block() const { return m_block; }
    [[nodiscard]] std::size_t cells() const {
        return static_cast<std::size_t>(m_rows) * static_cast<std::size_t>(m_columns);
    }
    /// The cell of a taxel.
    [[nodiscard]] std::size_t cellOf(int row, int column) const {
        return static_cast<std::size_t>(row / m_block) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(column / m_block);
    }

    /// Edges of a cell in the array's frame, without gap.
    struct Edges {
        double x0_m, x1_m, y0_m, y1_m;
    };
    [[nodiscard]] Edges edges(int row, int column) const;

    /// Largest load of each cell; NaN where every taxel is dead or not finite; negative loads count as 0.
    /// load_N: the layout's taxels; dead: as many, or empty; cell_N: cells().
    void pool(std::span<const float> load_N, std::span<const std::uint8_t> dead,
              std::span<float> cell_N) const;

private:
    core::ArrayLayout m_layout;
    int m_block = 1;
    int m_rows = 0;
    int m_columns = 0;
};

} // namespace teleta::view3d
