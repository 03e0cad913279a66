// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/link/frame_clock.h"

#include <algorithm>
#include <cmath>

namespace teleta::link {

namespace {

constexpr double kMeanShare = 1.0 / 16.0;

bool isGap(double interval, double period) {
    return interval >= 1.5 * period + 1.0;
}

} // namespace

FrameClock::Step FrameClock::advance(std::uint32_t timestamp, double hostTime_s) {
    const std::uint32_t interval = (timestamp - m_last) & (0xFFFF'FFFFU >> (32 - m_bits));
    Step step;
    step.restarted = m_running && (interval >> (m_bits - 1)) != 0;
    if (!m_running || step.restarted) {
        m_time_s = std::max(m_time_s, hostTime_s);
        m_period = 0.0;
    } else {
        const auto ticks = static_cast<double>(interval);
        m_time_s += ticks * m_tick_s;
        if (m_period > 0.0 && isGap(ticks, m_period))
            step.lost = static_cast<std::uint64_t>(std::llround(ticks / m_period)) - 1;
        else if (m_period == 0.0 || isGap(m_period, ticks))
            m_period = ticks; // the first interval may hold a loss itself: a much shorter one replaces it
        else
            m_period += kMeanShare * (ticks - m_period);
    }
    m_last = timestamp;
    m_running = true;
    step.time_s = m_time_s;
    return step;
}

void FrameClock::restart() {
    m_running = false;
}

} // namespace teleta::link
