// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace teleta::contact::test {

/// The array of the tactile servoing paper.
constexpr core::ArrayLayout kPaperArray{6, 14, 0.0034};

/// One frame with its layout, addressed by row and column.
struct Frame {
    core::ArrayLayout layout;
    std::vector<float> load_N;

    explicit Frame(const core::ArrayLayout& shape = kPaperArray)
        : layout(shape)
        , load_N(shape.taxels(), 0.0F) {}

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(layout.columns) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] float& at(int row, int column) { return load_N[index(row, column)]; }
    [[nodiscard]] float at(int row, int column) const { return load_N[index(row, column)]; }

    /// The frame with its taxels at other places of a layout: place(row, column) of the old taxel.
    template <typename Place>
    [[nodiscard]] Frame moved(const core::ArrayLayout& shape, const Place& place) const {
        Frame result(shape);
        for (int row = 0; row < layout.rows; ++row) {
            for (int column = 0; column < layout.columns; ++column) {
                const std::pair<int, int> to = place(row, column);
                if (at(row, column) != 0.0F)
                    result.at(to.first, to.second) = at(row, column);
            }
        }
        return result;
    }
    [[nodiscard]] Frame shifted(int rows, int columns) const {
        return moved(layout, [&](int row, int column) { return std::pair{row + rows, column + columns}; });
    }
    /// Columns in reverse order: x becomes -x.
    [[nodiscard]] Frame mirrored() const {
        return moved(layout, [&](int row, int column) {
            return std::pair{row, layout.columns - 1 - column};
        });
    }
    /// A quarter turn about z: (x, y) becomes (-y, x).
    [[nodiscard]] Frame turned() const {
        return moved({layout.columns, layout.rows, layout.pitchX_m}, [&](int row, int column) {
            return std::pair{column, layout.rows - 1 - row};
        });
    }
    [[nodiscard]] Frame scaled(float factor) const {
        Frame result = *this;
        for (float& load : result.load_N)
            load *= factor;
        return result;
    }
};

/// A rectangle of equal loads, bounds inclusive.
inline Frame block(const core::ArrayLayout& layout, int minRow, int maxRow, int minColumn, int maxColumn,
                   float load_N) {
    Frame frame(layout);
    for (int row = minRow; row <= maxRow; ++row)
        for (int column = minColumn; column <= maxColumn; ++column)
            frame.at(row, column) = load_N;
    return frame;
}

/// Random loads 0.01 .. 3 N, of which share are 0; margin taxels at each border stay 0.
inline Frame randomFrame(std::mt19937& random, const core::ArrayLayout& layout, double share,
                         int margin = 0) {
    Frame frame(layout);
    std::uniform_real_distribution<float> load(0.01F, 3.0F);
    std::bernoulli_distribution empty(share);
    for (int row = margin; row < layout.rows - margin; ++row)
        for (int column = margin; column < layout.columns - margin; ++column)
            if (!empty(random))
                frame.at(row, column) = load(random);
    return frame;
}

} // namespace teleta::contact::test
