// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace teleta::ros_arm {

/// Time since 1970 by this computer's clock, with which stamps are compared. Thread: any.
[[nodiscard]] inline std::int64_t wallClock_ns() {
    return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
}
[[nodiscard]] inline double wallClock_s() {
    return static_cast<double>(wallClock_ns()) * 1e-9;
}

} // namespace teleta::ros_arm
