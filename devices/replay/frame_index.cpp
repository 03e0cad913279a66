// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/frame_index.h"

#include <algorithm>

namespace teleta::replay {

void FrameIndex::add(const FramePlace& place) {
    const std::scoped_lock lock(m_mutex);
    m_extent.lastTime_s = place.time_s;
    m_extent.frames = place.frame + 1;
    if (place.frame % m_stride != 0)
        return;
    if (m_places.size() == kMaximumPlaces) {
        for (std::size_t i = 0; 2 * i < m_places.size(); ++i)
            m_places[i] = m_places[2 * i];
        m_places.resize((m_places.size() + 1) / 2);
        m_stride *= 2;
    }
    // The new stride may leave this one out as well.
    if (place.frame % m_stride == 0)
        m_places.push_back(place);
}

void FrameIndex::complete() {
    const std::scoped_lock lock(m_mutex);
    m_extent.complete = true;
}

FrameIndex::Extent FrameIndex::extent() const {
    const std::scoped_lock lock(m_mutex);
    return m_extent;
}

FramePlace FrameIndex::atFrame(std::uint64_t frame) const {
    const std::scoped_lock lock(m_mutex);
    const auto after = std::ranges::upper_bound(m_places, frame, {}, &FramePlace::frame);
    return after == m_places.begin() ? m_places.front() : *(after - 1);
}

FramePlace FrameIndex::beforeTime(double time_s) const {
    const std::scoped_lock lock(m_mutex);
    // Several frames may have the same time: the first of them may stand before the place that is known.
    const auto notBefore = std::ranges::lower_bound(m_places, time_s, {}, &FramePlace::time_s);
    return notBefore == m_places.begin() ? m_places.front() : *(notBefore - 1);
}

} // namespace teleta::replay
