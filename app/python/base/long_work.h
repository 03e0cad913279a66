// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/base/errors.h"

#include <cstdint>
#include <optional>
#include <pybind11/pybind11.h>
#include <utility>

namespace teleta::python {

/// Lets long work without the interpreter's lock notice Ctrl-C and tell how far it is. Signals are looked at
/// every 50 ms, progress(done, all) is called at most ten times a second. Thread: one.
class LongWork {
public:
    /// progress: a callable or None. Needs the interpreter's lock, as the destructor does.
    explicit LongWork(py::object progress = py::none())
        : m_progress(std::move(progress)) {}

    /// Call often, without the interpreter's lock. False: the work is to end, and rethrow() says why.
    [[nodiscard]] bool goOn(double done = 0.0, double all = 0.0);

    /// Throws what a signal handler or progress() raised, if anything. Needs the interpreter's lock.
    void rethrow();

    /// The value of an Expected that the work gave; what was raised meanwhile goes before its error.
    template <typename T>
    [[nodiscard]] T valueOf(core::Expected<T> expected) {
        rethrow();
        return python::valueOf(std::move(expected));
    }

private:
    py::object m_progress;
    std::optional<py::error_already_set> m_raised;
    std::int64_t m_nextLook_ns = 0;
    std::int64_t m_nextProgress_ns = 0;
};

} // namespace teleta::python
