// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

namespace teleta::core {

/// A mailbox of size one for commands to a device or to the pipeline: the latest command wins, an older one
/// that nobody took is replaced and counted. take() empties the box before the command is carried out, so a
/// command that arrives meanwhile is not lost. Thread: post and take from any.
template <typename T>
class Mailbox {
public:
    void post(T command) {
        const std::scoped_lock lock(m_mutex);
        if (m_command)
            ++m_replaced;
        m_command = std::move(command);
        m_full.store(true, std::memory_order_release);
    }

    [[nodiscard]] std::optional<T> take() {
        if (!m_full.load(std::memory_order_acquire))
            return std::nullopt;
        const std::scoped_lock lock(m_mutex);
        m_full.store(false, std::memory_order_relaxed);
        return std::exchange(m_command, std::nullopt);
    }

    [[nodiscard]] unsigned long long replaced() const {
        const std::scoped_lock lock(m_mutex);
        return m_replaced;
    }

private:
    mutable std::mutex m_mutex;
    std::atomic<bool> m_full{false};
    std::optional<T> m_command;
    unsigned long long m_replaced = 0;
};

} // namespace teleta::core
