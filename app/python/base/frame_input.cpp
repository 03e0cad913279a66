// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/frame_input.h"

#include <cmath>
#include <string>

namespace teleta::python {

core::ArrayLayout layoutOf(long long rows, long long columns, double pitch_m) {
    const auto side = [](long long value, const char* name) {
        if (value < 1 || value > core::ArrayLayout::kMaximumSide)
            throw wrongValue(name, "1 to " + std::to_string(core::ArrayLayout::kMaximumSide),
                             std::to_string(value));
        return static_cast<int>(value);
    };
    return {side(rows, "rows"), side(columns, "columns"), positive(pitch_m, "pitch_m")};
}

FrameInput FrameInput::read(py::handle frames, double pitch_m, const char* name) {
    FrameInput input;
    input.array = realArray<float>(frames, name);
    const py::ssize_t dimensions = input.array.ndim();
    if (dimensions != 2 && dimensions != 3)
        throw wrongValue(name, "(frames, rows, columns)", shapeText(input.array));
    input.layout = layoutOf(input.array.shape(dimensions - 2), input.array.shape(dimensions - 1), pitch_m);
    input.count = dimensions == 3 ? static_cast<std::size_t>(input.array.shape(0)) : 1;
    input.m_first = input.array.data();
    return input;
}

std::vector<double> frameTimes(py::handle time_s, std::size_t frames) {
    if (time_s.is_none())
        return {};
    // A single frame may come with a single number.
    const py::object listed = PyFloat_Check(time_s.ptr()) || PyLong_Check(time_s.ptr())
                                  ? py::object(py::make_tuple(time_s))
                                  : py::reinterpret_borrow<py::object>(time_s);
    std::vector<double> times = numbers(listed, "time_s", frames);
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!std::isfinite(times[i]) || (i > 0 && times[i] < times[i - 1]))
            throw wrongValue("time_s", "finite times that do not decrease",
                             std::string(py::repr(py::float_(times[i]))) + " at index " + std::to_string(i));
    }
    return times;
}

} // namespace teleta::python
