// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <utility>

namespace teleta::core {

/// Lets a worker sleep until a deadline or until it is told to stop.
/// Thread: until() from the worker's; the rest from any.
class WorkerWait {
public:
    explicit WorkerWait(std::shared_ptr<PacingClock> clock)
        : m_clock(std::move(clock)) {}

    [[nodiscard]] std::int64_t now_ns() const { return m_clock->now_ns(); }

    /// Returns false as soon as stop is requested; wake() has to follow the request.
    bool until(std::int64_t deadline_ns, const std::stop_token& stop) {
        std::unique_lock lock(m_mutex);
        return m_clock->sleepUntil(m_condition, lock, deadline_ns, stop);
    }
    void wake() {
        const std::scoped_lock lock(m_mutex);
        m_condition.notify_all();
    }

private:
    std::shared_ptr<PacingClock> m_clock;
    std::mutex m_mutex;
    std::condition_variable m_condition;
};

} // namespace teleta::core
