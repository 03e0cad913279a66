// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>

namespace teleta::core {

/// Nanoseconds of the steady clock. Every sample carries this time, taken at the read; nobody stamps it
/// again. Thread: any.
[[nodiscard]] inline std::int64_t steadyNow_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Seconds from one reading of the steady clock to another; negative when they are in reverse order.
[[nodiscard]] constexpr double elapsed_s(std::int64_t from_ns, std::int64_t to_ns) {
    return static_cast<double>(to_ns - from_ns) * 1e-9;
}

/// How long the machine has slept since it was started, to 1 ms: the steady clock stands still meanwhile.
/// Thread: any.
[[nodiscard]] inline std::int64_t suspendedSinceBoot_ns() {
    constexpr std::int64_t kUndisturbed_ns = 1'000'000;
    const auto read_ns = [](clockid_t clock) {
        timespec time{};
        (void)clock_gettime(clock, &time);
        return std::int64_t{time.tv_sec} * 1'000'000'000 + std::int64_t{time.tv_nsec};
    };
    for (;;) {
        const std::int64_t awake_ns = read_ns(CLOCK_MONOTONIC);
        const std::int64_t all_ns = read_ns(CLOCK_BOOTTIME);
        // A thread that was interrupted between the two would take that for sleep.
        if (read_ns(CLOCK_MONOTONIC) - awake_ns < kUndisturbed_ns)
            return all_ns - awake_ns;
    }
}

/// A steady time as a time point, for waits with an absolute deadline.
[[nodiscard]] inline std::chrono::steady_clock::time_point toTimePoint(std::int64_t time_ns) {
    return std::chrono::steady_clock::time_point(
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::nanoseconds(time_ns)));
}

} // namespace teleta::core
