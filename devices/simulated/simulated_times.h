// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

namespace teleta::simulated {

/// A simulated device lags at most so much.
inline constexpr double kLongestLag_s = 3600.0;
/// How long a device that is unplugged waits before it looks again: first, and at the most.
inline constexpr std::int64_t kFirstRetry_ns = 100'000'000;
inline constexpr std::int64_t kLongestRetry_ns = 2'000'000'000;

[[nodiscard]] inline std::int64_t toNs(double time_s) {
    return static_cast<std::int64_t>(std::llround(time_s * 1e9));
}

} // namespace teleta::simulated
