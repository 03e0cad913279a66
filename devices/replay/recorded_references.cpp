// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_references.h"

#include <algorithm>
#include <limits>

namespace teleta::replay {

RecordedReferences::RecordedReferences(const recording::Recording& recording,
                                       std::optional<std::size_t> stream) {
    if (!stream)
        return;
    m_track.emplace(recording, *stream);
    core::Expected<void> read = m_track->seek(std::numeric_limits<std::int64_t>::min());
    while (read && !m_track->atEnd()) {
        m_times_ns.push_back(m_track->time_ns());
        read = m_track->advance();
    }
}

core::GreyImage RecordedReferences::changeAt(std::int64_t time_ns) {
    if (m_times_ns.size() < 2)
        return {};
    const auto after = std::ranges::upper_bound(m_times_ns, time_ns);
    const std::size_t index =
        after == m_times_ns.begin() ? 0 : static_cast<std::size_t>(after - m_times_ns.begin()) - 1;
    if (index == m_inUse || !m_track->seek(m_times_ns[index]) || m_track->atEnd())
        return {};
    m_inUse = index;
    return m_track->image();
}

} // namespace teleta::replay
