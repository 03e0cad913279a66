// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace teleta::python {

namespace py = pybind11;

/// Each adds the functions and classes of one part to the module teleta._vision. They take all arguments by
/// position; names, defaults and documentation are in the Python files of the package.
void bindCamera(py::module_& module);
void bindTracker(py::module_& module);
void bindSimulation(py::module_& module);

} // namespace teleta::python
