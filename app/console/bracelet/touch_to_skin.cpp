// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/touch_to_skin.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace teleta::console {

void TouchToSkin::begin(pipeline::FeedbackSent sent) {
    m_last = FeedbackEvent{std::move(sent), std::nullopt, std::nullopt};
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
        m_latencies_s.push_back(*m_last->begin_s);
        if (m_latencies_s.size() > kLatencies)
            m_latencies_s.erase(m_latencies_s.begin());
    }
    m_last->onset_s = after_s(counters.onset_ns);
    return m_last->onset_s || m_last->begin_s.has_value() != began;
}

std::optional<double> TouchToSkin::newest_s() const {
    return m_latencies_s.empty() ? std::nullopt : std::optional(m_latencies_s.back());
}

std::optional<TouchToSkin::Latency> TouchToSkin::latency() const {
    if (m_latencies_s.empty())
        return std::nullopt;
    std::vector<double> sorted = m_latencies_s;
    std::ranges::sort(sorted);
    return Latency{core::quantileOf(sorted, 0.5), core::quantileOf(sorted, 0.99)};
}

} // namespace teleta::console
