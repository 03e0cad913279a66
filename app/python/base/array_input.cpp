// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_input.h"

#include <cmath>
#include <limits>
#include <string_view>

namespace teleta::python {

namespace {

/// Masked elements take the place of dead ones.
template <typename T>
py::object unmasked(py::handle argument) {
    if (!py::hasattr(argument, "mask") || !py::hasattr(argument, "filled"))
        return py::reinterpret_borrow<py::object>(argument);
    if constexpr (std::numeric_limits<T>::has_quiet_NaN)
        return argument.attr("astype")(py::dtype::of<T>())
            .attr("filled")(std::numeric_limits<double>::quiet_NaN());
    else
        return argument.attr("filled")(0);
}

void refuseKind(const py::array& array, const char* name) {
    constexpr std::string_view kReal = "biuf";
    if (kReal.find(array.dtype().kind()) == std::string_view::npos)
        throw py::type_error(std::string(name) + ": expected real numbers, got " +
                             std::string(py::str(array.dtype())));
}

} // namespace

template <typename T>
py::array_t<T, py::array::c_style> realArray(py::handle argument, const char* name) {
    using Array = py::array_t<T, py::array::c_style>;
    // The usual case first, and cheaply: exactly numpy's class, with the values as they are needed.
    if (Py_TYPE(argument.ptr()) == py::detail::npy_api::get().PyArray_Type_ && Array::check_(argument))
        return py::reinterpret_borrow<Array>(argument);
    const py::array any = py::array::ensure(argument);
    if (!any) {
        PyErr_Clear();
        throw py::type_error(std::string(name) + ": expected an array of real numbers");
    }
    refuseKind(any, name);
    const py::object whole = unmasked<T>(argument);
    const auto array = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(whole);
    if (!array) {
        PyErr_Clear();
        throw py::type_error(std::string(name) + ": expected an array of real numbers");
    }
    return py::reinterpret_borrow<Array>(array);
}

template py::array_t<float, py::array::c_style> realArray<float>(py::handle, const char*);
template py::array_t<double, py::array::c_style> realArray<double>(py::handle, const char*);
template py::array_t<std::uint8_t, py::array::c_style> realArray<std::uint8_t>(py::handle, const char*);

std::string shapeText(const py::array& array) {
    std::string text = "(";
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
    return text + (array.ndim() == 1 ? ",)" : ")");
}

void needShape(const py::array& array, const char* name, const std::vector<py::ssize_t>& shape,
               const char* expected) {
    bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size());
    for (std::size_t i = 0; fits && i < shape.size(); ++i)
        fits = shape[i] < 0 || shape[i] == array.shape(static_cast<py::ssize_t>(i));
    if (!fits)
        throw wrongValue(name, expected, shapeText(array));
}

std::vector<double> numbers(py::handle argument, const char* name, std::optional<std::size_t> length) {
    const auto array = realArray<double>(argument, name);
    const py::ssize_t wanted = length ? static_cast<py::ssize_t>(*length) : -1;
    const std::string expected = length ? "(" + std::to_string(*length) + ",)" : "(n,)";
    needShape(array, name, {wanted}, expected.c_str());
    const std::span<const double> values = valuesOf(array);
    return {values.begin(), values.end()};
}

double positive(double value, const char* name) {
    if (!std::isfinite(value) || value <= 0.0)
        throw wrongValue(name, "a finite number above 0", std::string(py::repr(py::float_(value))));
    return value;
}

double notNegative(double value, const char* name) {
    if (!std::isfinite(value) || value < 0.0)
        throw wrongValue(name, "a finite number of 0 or more", std::string(py::repr(py::float_(value))));
    return value;
}

std::string pathOf(py::handle argument) {
    return py::cast<std::string>(py::module_::import("os").attr("fsdecode")(argument));
}

} // namespace teleta::python
