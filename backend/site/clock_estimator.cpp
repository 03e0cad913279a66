// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site/clock_estimator.h"

#include <algorithm>
#include <cstdlib>

namespace teleta::site {

namespace {

/// Steady clocks count from the start of the machine: 73 years.
constexpr std::int64_t kLatest_ns = std::int64_t{1} << 61;

} // namespace

std::int64_t ClockEstimator::bound_ns(const Sample& sample, std::int64_t now_console_ns) {
    const std::int64_t age_ns = std::max<std::int64_t>(0, now_console_ns - sample.at_console_ns);
    return (sample.delay_ns + 1) / 2 + age_ns / 10'000;
}

bool ClockEstimator::add(const ClockProbe& probe) {
    // What comes over the network may be any number; sums of these do not overflow.
    const std::array<std::int64_t, 4> times{probe.sent_console_ns, probe.received_site_ns,
                                            probe.answered_site_ns, probe.received_console_ns};
    if (!std::ranges::all_of(times, [](std::int64_t time) { return time >= 0 && time < kLatest_ns; })) {
        ++m_ignored;
        return false;
    }
    Sample sample;
    sample.at_console_ns = probe.received_console_ns;
    sample.delay_ns = (probe.received_console_ns - probe.sent_console_ns) -
                      (probe.answered_site_ns - probe.received_site_ns);
    if (sample.delay_ns < 0 || probe.answered_site_ns < probe.received_site_ns) {
        ++m_ignored;
        return false;
    }
    const std::int64_t there_ns = probe.received_site_ns - probe.sent_console_ns;
    const std::int64_t back_ns = probe.answered_site_ns - probe.received_console_ns;
    sample.offset_ns = there_ns + (back_ns - there_ns) / 2;
    if (const std::optional<ClockOffset> known = offset(sample.at_console_ns)) {
        const std::int64_t apart_ns = std::abs(known->offset_ns - sample.offset_ns);
        if (apart_ns > known->bound_ns + bound_ns(sample, sample.at_console_ns)) {
            ++m_jumps;
            m_count = 0;
            m_next = 0;
        }
    }
    m_samples[m_next] = sample;
    m_next = (m_next + 1) % kWindow;
    m_count = std::min(m_count + 1, kWindow);
    return true;
}

std::optional<ClockOffset> ClockEstimator::offset(std::int64_t now_console_ns) const {
    if (m_count == 0)
        return std::nullopt;
    const auto best =
        std::min_element(m_samples.begin(), m_samples.begin() + static_cast<std::ptrdiff_t>(m_count),
                         [now_console_ns](const Sample& a, const Sample& b) {
                             return bound_ns(a, now_console_ns) < bound_ns(b, now_console_ns);
                         });
    return ClockOffset{best->offset_ns, bound_ns(*best, now_console_ns), best->delay_ns};
}

void ClockEstimator::reset() {
    m_count = 0;
    m_next = 0;
}

std::int64_t SlewedOffset::follow(std::int64_t offset_ns, std::int64_t now_ns) {
    if (!m_started) {
        m_started = true;
        m_shown_ns = offset_ns;
    } else {
        const auto most_ns = static_cast<std::int64_t>(
            kSlew * static_cast<double>(std::max<std::int64_t>(0, now_ns - m_last_ns)));
        m_shown_ns += std::clamp(offset_ns - m_shown_ns, -most_ns, most_ns);
    }
    m_last_ns = now_ns;
    return m_shown_ns;
}

} // namespace teleta::site
