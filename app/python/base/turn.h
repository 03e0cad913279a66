// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <stdexcept>

namespace teleta::python {

/// Held while a thread is in an object that belongs to one thread at a time. Throws RuntimeError where
/// another one holds it.
class Turn {
public:
    explicit Turn(std::atomic_flag& busy)
        : m_busy(busy) {
        if (m_busy.test_and_set(std::memory_order_acquire))
            throw std::runtime_error("the object is in use by another thread");
    }
    ~Turn() { m_busy.clear(std::memory_order_release); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

private:
    std::atomic_flag& m_busy;
};

} // namespace teleta::python
