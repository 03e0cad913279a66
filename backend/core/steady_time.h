// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace teleta::core {

/// Nanoseconds of the steady clock. Every sample carries this time, taken at the read; nobody stamps it
/// again. Thread: any.
[[nodiscard]] inline std::int64_t steadyNow_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// A steady time as a time point, for waits with an absolute deadline.
[[nodiscard]] inline std::chrono::steady_clock::time_point toTimePoint(std::int64_t time_ns) {
    return std::chrono::steady_clock::time_point(
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::nanoseconds(time_ns)));
}

} // namespace teleta::core
