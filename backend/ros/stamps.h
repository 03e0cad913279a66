// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/messages.h"

#include <cstdint>
#include <optional>

namespace teleta::ros {

/// A stamp of a message in s of the clock of who sent it: wall clock or simulated time. Fractions are at most
/// one second off, whatever the message says. Thread: any (pure).
[[nodiscard]] inline double seconds(const Time& stamp) {
    return static_cast<double>(stamp.sec) + static_cast<double>(stamp.nanosec) * 1e-9;
}

/// The same in ns, which does not round.
[[nodiscard]] inline std::int64_t nanoseconds(const Time& stamp) {
    return std::int64_t{stamp.sec} * 1'000'000'000 + std::int64_t{stamp.nanosec};
}

/// The stamp of a time in ns since the epoch, which is not negative.
[[nodiscard]] inline Time stampOf(std::int64_t time_ns) {
    return {static_cast<std::int32_t>(time_ns / 1'000'000'000),
            static_cast<std::uint32_t>(time_ns % 1'000'000'000)};
}

/// Counts what is odd in the stamps of one stream. A zero stamp is not compared with its neighbours.
/// Thread: one.
class StampCheck {
public:
    void see(const Time& stamp) {
        const std::int64_t now_ns = nanoseconds(stamp);
        if (now_ns == 0) {
            ++m_zero;
            return;
        }
        m_equal += m_last_ns == now_ns ? 1 : 0;
        m_backward += m_last_ns && now_ns < *m_last_ns ? 1 : 0;
        m_last_ns = now_ns;
    }

    [[nodiscard]] std::uint64_t zero() const { return m_zero; }         ///< not set by the sender
    [[nodiscard]] std::uint64_t equal() const { return m_equal; }       ///< the same as the one before
    [[nodiscard]] std::uint64_t backward() const { return m_backward; } ///< before the one before

private:
    std::optional<std::int64_t> m_last_ns;
    std::uint64_t m_zero = 0;
    std::uint64_t m_equal = 0;
    std::uint64_t m_backward = 0;
};

} // namespace teleta::ros
