// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace teleta::core {

/// Geometry of a planar taxel array. Frame {s}: origin at the geometric centre, x along the columns, y along
/// the rows (row 0 has the most negative y), z out of the surface. Frames are stored row-major. Valid: 1 <=
/// rows, columns <= 1024; pitch_m > 0 and finite.
struct ArrayLayout {
    static constexpr int kMaximumSide = 1024;

    int rows = 6;
    int columns = 14;
    double pitch_m = 0.0034;

    [[nodiscard]] std::size_t taxels() const {
        return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    }
    [[nodiscard]] double x_m(double column) const { return (column - 0.5 * (columns - 1)) * pitch_m; }
    [[nodiscard]] double y_m(double row) const { return (row - 0.5 * (rows - 1)) * pitch_m; }
    [[nodiscard]] double taxelArea_m2() const { return pitch_m * pitch_m; }

    bool operator==(const ArrayLayout&) const = default;
};

} // namespace teleta::core
