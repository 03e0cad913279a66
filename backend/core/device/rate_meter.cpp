// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/rate_meter.h"

#include <algorithm>

namespace teleta::core {

RateMeter::RateMeter(std::int64_t window_ns, std::size_t maximumSamples)
    : m_window_ns(std::max<std::int64_t>(window_ns, 1))
    , m_ring(std::max<std::size_t>(maximumSamples, 2)) {
}

void RateMeter::add(std::int64_t time_ns) {
    if (m_count > 0 && time_ns < m_ring[(m_first + m_count - 1) % m_ring.size()])
        reset();
    dropBefore(time_ns - m_window_ns);
    if (m_count == m_ring.size()) {
        m_first = (m_first + 1) % m_ring.size();
        --m_count;
    }
    m_ring[(m_first + m_count) % m_ring.size()] = time_ns;
    ++m_count;
}

double RateMeter::rate_Hz(std::int64_t now_ns) const {
    if (m_count < 2)
        return 0.0;
    const std::int64_t first_ns = m_ring[m_first];
    const std::int64_t last_ns = m_ring[(m_first + m_count - 1) % m_ring.size()];
    if (last_ns <= first_ns || now_ns - last_ns > m_window_ns)
        return 0.0;
    return static_cast<double>(m_count - 1) * 1e9 / static_cast<double>(last_ns - first_ns);
}

void RateMeter::reset() {
    m_first = 0;
    m_count = 0;
}

void RateMeter::dropBefore(std::int64_t time_ns) {
    while (m_count > 0 && m_ring[m_first] < time_ns) {
        m_first = (m_first + 1) % m_ring.size();
        --m_count;
    }
}

} // namespace teleta::core
