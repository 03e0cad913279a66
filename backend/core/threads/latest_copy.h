// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <utility>

namespace teleta::core {

/// A small value that one thread sets and any thread may copy. The lock is held only while the value is
/// copied, never around I/O or drawing. Thread: any.
template <typename T>
class LatestCopy {
public:
    void set(T value) {
        const std::scoped_lock lock(m_mutex);
        m_value = std::move(value);
    }
    [[nodiscard]] T get() const {
        const std::scoped_lock lock(m_mutex);
        return m_value;
    }

private:
    mutable std::mutex m_mutex;
    T m_value{};
};

} // namespace teleta::core
