// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/errors.h"

namespace teleta::python {

namespace {

const char* wordOf(core::ErrorKind kind) {
    switch (kind) {
    case core::ErrorKind::badInput:
        return "bad_input";
    case core::ErrorKind::notFound:
        return "not_found";
    case core::ErrorKind::ioFailed:
        return "io_failed";
    case core::ErrorKind::refused:
        return "refused";
    case core::ErrorKind::cancelled:
        return "cancelled";
    case core::ErrorKind::unavailable:
        return "unavailable";
    }
    return "bad_input";
}

py::object orNone(const std::string& text) {
    return text.empty() ? py::object(py::none()) : py::object(py::str(text));
}

py::object orNone(long long number) {
    return number == 0 ? py::object(py::none()) : py::object(py::int_(number));
}

void raise(const core::Error& error) {
    if (error.kind == core::ErrorKind::cancelled) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
        return;
    }
    const py::object exception =
        py::module_::import("teleta._errors")
            .attr("error_of")(wordOf(error.kind), error.message, orNone(error.where.file),
                              orNone(error.where.line), orNone(error.where.column), orNone(error.expected));
    PyErr_SetObject(py::type::handle_of(exception).ptr(), exception.ptr());
}

} // namespace

void registerErrors() {
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown)
                std::rethrow_exception(thrown);
        } catch (const Failure& failure) {
            raise(failure.error());
        }
    });
}

void warnOfDamage(unsigned long long blocks, const std::string& path) {
    if (blocks == 0)
        return;
    const py::object category = py::module_::import("teleta._errors").attr("DamagedDataWarning");
    const std::string text = path + ": " + std::to_string(blocks) +
                             (blocks == 1 ? " damaged block was left out" : " damaged blocks were left out");
    // The caller of the Python function that called this one.
    if (PyErr_WarnEx(category.ptr(), text.c_str(), 2) != 0)
        throw py::error_already_set();
}

py::value_error wrongValue(const char* name, const std::string& expected, const std::string& got) {
    return py::value_error(std::string(name) + ": expected " + expected + ", got " + got);
}

} // namespace teleta::python
