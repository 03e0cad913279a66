// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"

#include <condition_variable>
#include <cstdint>
#include <limits>
#include <mutex>

namespace teleta::core {

/// The clock of a worker that keeps a schedule, and its wait that commands can end. A test puts a clock in
/// its place that stands still until the test moves it.
/// Thread: any.
class PacingClock {
public:
    /// A deadline that never comes.
    static constexpr std::int64_t kNever_ns = std::numeric_limits<std::int64_t>::max();

    PacingClock() = default;
    virtual ~PacingClock() = default;
    PacingClock(const PacingClock&) = delete;
    PacingClock& operator=(const PacingClock&) = delete;

    [[nodiscard]] virtual std::int64_t now_ns() const { return steadyNow_ns(); }

    /// How long the machine has slept since it was started. now_ns() stands still meanwhile: what was due
    /// before is due after the waking as if nothing had been.
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
};

} // namespace teleta::core
