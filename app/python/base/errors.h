// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <exception>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>

namespace teleta::python {

namespace py = pybind11;

/// A failure of the backend on its way to Python, where it becomes teleta.Error or one of its classes.
class Failure : public std::exception {
public:
    explicit Failure(core::Error error)
        : m_error(std::move(error)) {}
    [[nodiscard]] const core::Error& error() const { return m_error; }
    [[nodiscard]] const char* what() const noexcept override { return m_error.message.c_str(); }

private:
    core::Error m_error;
};

/// The value of an Expected; throws Failure with its error. Thread: any, with or without the interpreter's
/// lock.
template <typename T>
[[nodiscard]] T valueOf(core::Expected<T> expected) {
    if (!expected)
        throw Failure(std::move(expected).error());
    return *std::move(expected);
}
inline void valueOf(const core::Expected<void>& expected) {
    if (!expected)
        throw Failure(expected.error());
}

/// Makes this extension module raise Failure as an exception of teleta._errors. Call once a module.
void registerErrors();

/// Raises teleta.DamagedDataWarning with the count; nothing for 0. Throws py::error_already_set where
/// warnings are errors. Needs the interpreter's lock.
void warnOfDamage(unsigned long long blocks, const std::string& path);

/// ValueError that names the parameter: "NAME: expected EXPECTED, got GOT".
[[nodiscard]] py::value_error wrongValue(const char* name, const std::string& expected,
                                         const std::string& got);

} // namespace teleta::python
