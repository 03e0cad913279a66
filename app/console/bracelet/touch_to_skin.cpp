// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/touch_to_skin.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace teleta::console {

void TouchToSkin::begin(pipeline::FeedbackSent sent, const std::optional<site::ClockOffset>& clock) {
    m_last = TouchReceipt{.sent = std::move(sent), .clock = clock};
    m_receipts.push_back(*m_last);
    if (m_receipts.size() > kReceipts)
        m_receipts.pop_front();
}

bool TouchToSkin::isOpen() const {
    return m_last && !m_last->onset_s && !m_last->sent.patternId.empty() && !m_last->sent.missing &&
           !m_last->sent.refused;
}

bool TouchToSkin::update(const playback::PlayerCounters& counters) {
    if (!isOpen())
        return false;
    // A frame from before the touch is of another pattern.
    const auto after_s = [felt_ns = m_last->sent.felt_ns](std::int64_t frame_ns) {
        return frame_ns < felt_ns ? std::nullopt
                                  : std::optional(static_cast<double>(frame_ns - felt_ns) * 1e-9);
    };
    const bool began = m_last->begin_s.has_value();
    if (!began && (m_last->begin_s = after_s(counters.firstFrame_ns))) {
        const auto bound_ns = m_last->clock ? m_last->clock->bound_ns : std::int64_t{0};
        m_begun.push_back({*m_last->begin_s, static_cast<double>(bound_ns) * 1e-9});
        if (m_begun.size() > kLatencies)
            m_begun.erase(m_begun.begin());
    }
    m_last->onset_s = after_s(counters.onset_ns);
    m_receipts.back() = *m_last; // it is the newest
    return m_last->onset_s || m_last->begin_s.has_value() != began;
}

std::optional<double> TouchToSkin::newest_s() const {
    return m_begun.empty() ? std::nullopt : std::optional(m_begun.back().latency_s);
}

std::optional<TouchToSkin::Latency> TouchToSkin::latency() const {
    if (m_begun.empty())
        return std::nullopt;
    std::vector<double> sorted;
    Latency latency;
    for (const Begun& touch : m_begun) {
        sorted.push_back(touch.latency_s);
        latency.bound_s = std::max(latency.bound_s, touch.bound_s);
    }
    std::ranges::sort(sorted);
    latency.median_s = core::quantileOf(sorted, 0.5);
    latency.p99_s = core::quantileOf(sorted, 0.99);
    return latency;
}

} // namespace teleta::console
