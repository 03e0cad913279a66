// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

namespace teleta::core {

/// Delays between attempts to connect: each twice as long as the one before, up to a longest one.
/// Thread: one.
class Backoff {
public:
    /// 0 < first_ns <= longest_ns.
    constexpr Backoff(std::int64_t first_ns, std::int64_t longest_ns)
        : m_first_ns(first_ns)
        , m_longest_ns(longest_ns)
        , m_next_ns(first_ns) {}

    /// How long to wait before the next attempt.
    [[nodiscard]] constexpr std::int64_t next_ns() {
        return std::exchange(m_next_ns, std::min(2 * m_next_ns, m_longest_ns));
    }
    /// After a success: the next delay is the first one again.
    constexpr void reset() { m_next_ns = m_first_ns; }

private:
    std::int64_t m_first_ns;
    std::int64_t m_longest_ns;
    std::int64_t m_next_ns;
};

} // namespace teleta::core
