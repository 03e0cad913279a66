// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/recent_times.h"

#include <algorithm>

namespace teleta::playback {

RecentTimes::RecentTimes() {
    m_ring.reserve(kKept);
}

void RecentTimes::add(std::int64_t time_ns) {
    if (m_ring.size() < kKept)
        m_ring.push_back(time_ns);
    else
        m_ring[m_count % kKept] = time_ns;
    ++m_count;
    m_longest_ns = std::max(m_longest_ns, time_ns);
}

void RecentTimes::clear() {
    m_ring.clear();
    m_count = 0;
    m_longest_ns = 0;
}

std::int64_t RecentTimes::median_ns() const {
    if (m_ring.empty())
        return 0;
    std::vector<std::int64_t> times = m_ring;
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>((times.size() - 1) / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

} // namespace teleta::playback
