// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/interface.h"
#include "backend/core/steady_time.h"

#include <condition_variable>
#include <cstdint>
#include <limits>
#include <mutex>
#include <stop_token>

namespace teleta::core {

/// The clock of a worker that keeps a schedule, and its wait, which commands can end. Tests replace it with a
/// clock that they move themselves.
/// Thread: any.
class PacingClock : public Interface {
public:
    /// A deadline that never comes.
    static constexpr std::int64_t kNever_ns = std::numeric_limits<std::int64_t>::max();

    [[nodiscard]] virtual std::int64_t now_ns() const { return steadyNow_ns(); }

    /// How long the machine has slept since it was started; now_ns() stands still meanwhile.
    [[nodiscard]] virtual std::int64_t suspended_ns() const { return suspendedSinceBoot_ns(); }

    /// Waits until the condition is notified or the deadline has passed; it may also return without either.
    /// lock: held by the caller before and after.
    virtual void waitUntil(std::condition_variable& condition, std::unique_lock<std::mutex>& lock,
                           std::int64_t deadline_ns) {
        if (deadline_ns == kNever_ns)
            condition.wait(lock);
        else
            condition.wait_until(lock, toTimePoint(deadline_ns));
    }

    /// Waits until the deadline has passed, however often the condition is notified. False as soon as stop is
    /// requested and the condition notified.
    bool sleepUntil(std::condition_variable& condition, std::unique_lock<std::mutex>& lock,
                    std::int64_t deadline_ns, const std::stop_token& stop) {
        while (!stop.stop_requested() && now_ns() < deadline_ns)
            waitUntil(condition, lock, deadline_ns);
        return !stop.stop_requested();
    }
};

} // namespace teleta::core
