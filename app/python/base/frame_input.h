// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/base/array_input.h"
#include "backend/core/data/array_layout.h"

#include <cstddef>
#include <span>
#include <vector>

namespace teleta::python {

/// Tactile frames that a caller gave: (frames, rows, columns), or (rows, columns) for one.
struct FrameInput {
    py::array_t<float, py::array::c_style> array;
    core::ArrayLayout layout;
    std::size_t count = 0;

    [[nodiscard]] std::span<const float> frame(std::size_t index) const {
        return {m_first + index * layout.taxels(), layout.taxels()};
    }

    /// ValueError for another shape, TypeError for other numbers. Needs the interpreter's lock; frame() does
    /// not.
    [[nodiscard]] static FrameInput read(py::handle frames, double pitch_m, const char* name = "frames");

private:
    const float* m_first = nullptr;
};

/// The layout of an array; ValueError for sides outside 1..1024 or a pitch that is not > 0.
[[nodiscard]] core::ArrayLayout layoutOf(long long rows, long long columns, double pitch_m);

/// The times of `frames` frames: an array of as many that do not decrease, or None (empty). ValueError
/// otherwise.
[[nodiscard]] std::vector<double> frameTimes(py::handle time_s, std::size_t frames);

} // namespace teleta::python
