// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace teleta::core {

/// Lets producers wake one consumer thread that serves several queues. A notification is never lost: one that
/// comes before the wait ends the wait at once. Several notifications before a wait count as one.
/// Thread: notify from any, wait from one.
class Wakeup {
public:
    void notify() {
        {
            const std::scoped_lock lock(m_mutex);
            m_pending = true;
        }
        m_condition.notify_one();
    }

    /// Waits until notified or until the time-out has passed; true when notified.
    bool waitFor(std::chrono::nanoseconds timeout) {
        std::unique_lock lock(m_mutex);
        const bool notified = m_condition.wait_for(lock, timeout, [this] { return m_pending; });
        m_pending = false;
        return notified;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_condition;
    bool m_pending = false;
};

} // namespace teleta::core
