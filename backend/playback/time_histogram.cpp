// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/time_histogram.h"

#include <algorithm>
#include <bit>

namespace teleta::playback {

/// Times below 2^kBits have a bucket each; above, the octave and the kBits bits behind the leading one count.
std::size_t TimeHistogram::bucketOf(std::uint64_t time_ns) {
    const auto width = static_cast<unsigned>(std::bit_width(time_ns));
    if (width <= kBits)
        return static_cast<std::size_t>(time_ns);
    const unsigned shift = width - 1 - kBits;
    const std::size_t octave = static_cast<std::size_t>(shift) + 1;
    return (octave << kBits) + static_cast<std::size_t>((time_ns >> shift) - (1ULL << kBits));
}

std::uint64_t TimeHistogram::endOf(std::size_t bucket) {
    const std::size_t octave = bucket >> kBits;
    if (octave == 0)
        return bucket;
    const std::uint64_t mantissa = (1ULL << kBits) + (bucket & ((1ULL << kBits) - 1));
    return ((mantissa + 1) << (octave - 1)) - 1;
}

void TimeHistogram::add(std::int64_t time_ns) {
    const std::int64_t time = std::max<std::int64_t>(time_ns, 0);
    ++m_counts[std::min(bucketOf(static_cast<std::uint64_t>(time)), kBuckets - 1)];
    ++m_count;
    m_longest_ns = std::max(m_longest_ns, time);
}

std::int64_t TimeHistogram::quantile_ns(double share) const {
    if (m_count == 0)
        return 0;
    const double wanted = std::clamp(share, 0.0, 1.0) * static_cast<double>(m_count);
    std::uint64_t sum = 0;
    for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
        sum += m_counts[bucket];
        if (sum > 0 && static_cast<double>(sum) >= wanted)
            return std::min(static_cast<std::int64_t>(endOf(bucket)), m_longest_ns);
    }
    return m_longest_ns;
}

} // namespace teleta::playback
