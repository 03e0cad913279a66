// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/touch_history.h"

#include <algorithm>
#include <utility>

namespace teleta::pipeline {

TouchHistory::Kind TouchHistory::add(TouchRecord& touch) {
    const auto known = std::ranges::find_if(m_heard, [&](const Heard& heard) {
        return heard.record.start_s < touch.ready_s && touch.start_s < heard.record.ready_s;
    });
    if (known == m_heard.end()) {
        touch.number = m_heard.size() + 1;
        m_heard.push_back({touch, std::exchange(m_closed, false), m_settings});
        return Kind::first;
    }
    touch.number = known->record.number;
    const bool isCutOff = touch.start_s > known->record.start_s + kCutOff_s;
    const bool wasCutOff = known->record.start_s > touch.start_s + kCutOff_s;
    if (wasCutOff || (!isCutOff && known->settings != m_settings)) {
        known->record = touch;
        known->settings = m_settings;
        return Kind::better;
    }
    const std::int64_t start_ns = touch.start_ns;
    const std::int64_t ready_ns = touch.ready_ns;
    const std::int64_t arrived_ns = touch.arrived_ns;
    touch = known->record;
    touch.start_ns = start_ns;
    touch.ready_ns = ready_ns;
    touch.arrived_ns = arrived_ns;
    return Kind::again;
}

void TouchHistory::fill(FoundObjects& objects) const {
    objects.clear();
    for (const Heard& heard : m_heard) {
        if (heard.ofAnotherObject)
            objects.closeAll();
        (void)objects.add(heard.record);
    }
}

} // namespace teleta::pipeline
