// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace teleta::playback {

/// Histogram of durations over a whole run, in buckets at most 3.2 % wide, so that
/// quantiles are known to that. Nothing is allocated. Thread: one.
class TimeHistogram {
public:
    /// Below 0 counts as 0.
    void add(std::int64_t time_ns);
    void clear() { *this = {}; }

    [[nodiscard]] std::uint64_t count() const { return m_count; }
    [[nodiscard]] std::int64_t longest_ns() const { return m_longest_ns; }
    /// Upper end of the bucket in which the share of all times ends, at most the longest time; 0 without any.
    /// share: 0 .. 1.
    [[nodiscard]] std::int64_t quantile_ns(double share) const;

private:
    static constexpr unsigned kBits = 5; ///< buckets an octave, as a power of two
    static constexpr std::size_t kBuckets = (64U - kBits) << kBits;

    [[nodiscard]] static std::size_t bucketOf(std::uint64_t time_ns);
    [[nodiscard]] static std::uint64_t endOf(std::size_t bucket);

    std::array<std::uint32_t, kBuckets> m_counts{};
    std::uint64_t m_count = 0;
    std::int64_t m_longest_ns = 0;
};

} // namespace teleta::playback
