// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/stream_clock.h"

#include <algorithm>
#include <limits>

namespace teleta::signal {

namespace {

constexpr double kShortestGap_s = 0.1;
constexpr double kPeriodsOfAGap = 5.0;
/// A stream that stood still for longer than this was held.
constexpr double kHeld_s = 0.5;

} // namespace

StreamClock::StreamClock(std::int64_t origin_ns, double nominalRate_Hz)
    : m_origin_ns(origin_ns)
    , m_longestStep_s(nominalRate_Hz > 0.0 ? std::max(kShortestGap_s, kPeriodsOfAGap / nominalRate_Hz)
                                           : std::numeric_limits<double>::infinity()) {
}

StreamClock::Step StreamClock::next(std::int64_t time_ns, double sourceTime_s, bool discontinuity) {
    const double step_s = sourceTime_s - m_sourceTime_s;
    const double passed_s = 1e-9 * static_cast<double>(time_ns - m_time_ns);
    const bool anew = !m_begun || discontinuity || !(step_s >= 0.0) || passed_s - step_s > kHeld_s;
    Step step;
    if (anew) {
        const double clock_s = 1e-9 * static_cast<double>(time_ns - m_origin_ns);
        step = {m_begun ? std::max(m_time_s, clock_s) : clock_s, m_begun};
        m_offset_s = step.time_s - sourceTime_s;
    } else {
        step = {sourceTime_s + m_offset_s, step_s > m_longestStep_s};
    }
    m_begun = true;
    m_time_ns = time_ns;
    m_sourceTime_s = sourceTime_s;
    m_time_s = step.time_s;
    return step;
}

} // namespace teleta::signal
