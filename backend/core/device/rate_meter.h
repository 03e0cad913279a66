// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::core {

/// Achieved rate of a stream: (n - 1) / (t_last - t_first) over the last samples of a window.
/// Returns 0 with fewer than two samples, with a window that spans no time, and once the newest sample is
/// older than the window. Nothing is allocated after construction. Thread: one.
class RateMeter {
public:
    /// window_ns > 0; at most maximumSamples arrivals are kept (>= 2), so high rates are averaged over less
    /// time.
    explicit RateMeter(std::int64_t window_ns = 1'000'000'000, std::size_t maximumSamples = 1024);

    /// Registers one arrival. time_ns must not decrease; a decreasing time empties the window.
    void add(std::int64_t time_ns);
    [[nodiscard]] double rate_Hz(std::int64_t now_ns) const;
    void reset();

private:
    void dropBefore(std::int64_t time_ns);

    std::int64_t m_window_ns;
    std::vector<std::int64_t> m_ring;
    std::size_t m_first = 0;
    std::size_t m_count = 0;
};

} // namespace teleta::core
