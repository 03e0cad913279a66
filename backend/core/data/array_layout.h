// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

namespace teleta::core {

/// A planar grid of taxels. Frame {s}: origin at the geometric centre, x along the columns, y along the rows
/// (row 0 has the most negative y), z out of the surface. Frames are stored row-major. Valid: 1 <= rows,
/// columns <= 1024; pitches > 0 and finite. pitchY_m is pitchX_m unless it is given.
struct ArrayLayout {
    static constexpr int kMaximumSide = 1024;

    int rows = 6;
    int columns = 14;
    double pitchX_m = 0.0034;   ///< from column to column
    double pitchY_m = pitchX_m; ///< from row to row

    [[nodiscard]] std::size_t taxels() const {
        return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    }
    [[nodiscard]] double x_m(double column) const { return (column - 0.5 * (columns - 1)) * pitchX_m; }
    [[nodiscard]] double y_m(double row) const { return (row - 0.5 * (rows - 1)) * pitchY_m; }
    [[nodiscard]] double taxelArea_m2() const { return pitchX_m * pitchY_m; }
    [[nodiscard]] double largerPitch_m() const { return std::max(pitchX_m, pitchY_m); }
    /// Height of a cell by its width; 1: square.
    [[nodiscard]] double aspect() const { return pitchY_m / pitchX_m; }

    void setPitch_m(double pitch_m) { pitchX_m = pitchY_m = pitch_m; }

    bool operator==(const ArrayLayout&) const = default;
};

} // namespace teleta::core
