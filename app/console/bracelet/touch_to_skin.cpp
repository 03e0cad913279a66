// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/touch_to_skin.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace teleta::console {

void TouchToSkin::begin(pipeline::FeedbackSent sent, const std::optional<site::ClockOffset>& clock) {
    m_receipts.push_back({.sent = std::move(sent), .clock = clock});
    if (m_receipts.size() > kReceipts)
        m_receipts.pop_front();
    m_isKnown = true;
}

bool TouchToSkin::isOpen() const {
    const TouchReceipt* touch = last();
    return touch != nullptr && !touch->onset_s && !touch->sent.patternId.empty() && !touch->sent.missing &&
           !touch->sent.refused;
}

bool TouchToSkin::update(const playback::PlayerCounters& counters) {
    if (!isOpen())
        return false;
    TouchReceipt& touch = m_receipts.back();
    // A frame from before the touch is of another pattern.
    const auto after_s = [felt_ns = touch.sent.felt_ns](std::int64_t frame_ns) {
        return frame_ns < felt_ns ? std::nullopt
                                  : std::optional(static_cast<double>(frame_ns - felt_ns) * 1e-9);
    };
    const bool began = touch.begin_s.has_value();
    if (!began && (touch.begin_s = after_s(counters.firstFrame_ns))) {
        m_begun.push_back({*touch.begin_s, touch.clockBound_s().value_or(0.0)});
        if (m_begun.size() > kLatencies)
            m_begun.erase(m_begun.begin());
    }
    touch.onset_s = after_s(counters.onset_ns);
    return touch.onset_s || touch.begin_s.has_value() != began;
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
