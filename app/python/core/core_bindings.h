// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace teleta::python {

namespace py = pybind11;

/// Each adds the functions and classes of one part to the module teleta._core. They take all arguments by
/// position; names, defaults and documentation are in the Python files of the package.
void bindFrames(py::module_& module);
void bindProcessor(py::module_& module);
void bindGains(py::module_& module);
void bindTouch(py::module_& module);
void bindContour(py::module_& module);
void bindPatterns(py::module_& module);
void bindRecordings(py::module_& module);
void bindStudy(py::module_& module);

} // namespace teleta::python
