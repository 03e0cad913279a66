// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/base/errors.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <span>
#include <string>
#include <vector>

namespace teleta::python {

/// An argument as an array of real numbers, C-contiguous and in native byte order: itself where it is one
/// already, otherwise a converted copy. Masked elements become NaN (0 where T is no float). TypeError for
/// complex numbers, text and objects. name: of the parameter. Needs the interpreter's lock, as all below.
template <typename T>
[[nodiscard]] py::array_t<T, py::array::c_style> realArray(py::handle argument, const char* name);

extern template py::array_t<float, py::array::c_style> realArray<float>(py::handle, const char*);
extern template py::array_t<double, py::array::c_style> realArray<double>(py::handle, const char*);
extern template py::array_t<std::uint8_t, py::array::c_style> realArray<std::uint8_t>(py::handle,
                                                                                      const char*);

/// "(6, 14)".
[[nodiscard]] std::string shapeText(const py::array& array);

/// ValueError "NAME: expected EXPECTED, got (6,)" unless the array has the shape; -1 stands for any length.
void needShape(const py::array& array, const char* name, const std::vector<py::ssize_t>& shape,
               const char* expected);

/// One-dimensional numbers; length: how many, or empty for any.
[[nodiscard]] std::vector<double> numbers(py::handle argument, const char* name,
                                          std::optional<std::size_t> length = std::nullopt);

/// ValueError unless the number is finite and > 0 (or >= 0); returns it.
double positive(double value, const char* name);
double notNegative(double value, const char* name);

/// A path from str, bytes or os.PathLike, as UTF-8 text of the file system.
[[nodiscard]] std::string pathOf(py::handle argument);

/// The values of an array that realArray() made.
template <typename T>
[[nodiscard]] std::span<const T> valuesOf(const py::array_t<T, py::array::c_style>& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

} // namespace teleta::python
