// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::playback {

/// How long something took: the longest of all, and the median of the newest 4096. Nothing is allocated after
/// construction but by median_ns(). Thread: one.
class RecentTimes {
public:
    static constexpr std::size_t kKept = 4096;

    RecentTimes();

    void add(std::int64_t time_ns);
    void clear();

    /// The middle one, of an even number the lower of the two in the middle; 0 when there was none.
    [[nodiscard]] std::int64_t median_ns() const;
    [[nodiscard]] std::int64_t longest_ns() const { return m_longest_ns; }
    [[nodiscard]] std::uint64_t count() const { return m_count; }

private:
    std::vector<std::int64_t> m_ring;
    std::uint64_t m_count = 0;
    std::int64_t m_longest_ns = 0;
};

} // namespace teleta::playback
