// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_track.h"

#include <algorithm>

namespace teleta::replay {

RecordedTrack::RecordedTrack(const recording::Recording& recording, std::size_t stream)
    : m_reader(recording.reader(stream))
    , m_start_ns(recording.head().start_ns) {
}

std::span<const std::byte> RecordedTrack::bytes() const {
    const std::size_t size = m_block.values.size() / m_block.frames();
    return std::span(m_block.values).subspan(m_index * size, size);
}

core::Expected<void> RecordedTrack::seek(std::int64_t time_ns) {
    core::Expected<void> done = m_reader.seek(time_ns);
    m_block = {};
    m_index = 0;
    m_atEnd = true; // until there is a block
    if (done)
        done = nextBlock();
    while (done && !m_atEnd && this->time_ns() < time_ns)
        done = advance();
    return done;
}

core::Expected<void> RecordedTrack::advance() {
    if (++m_index < m_block.frames())
        return {};
    return nextBlock();
}

core::Expected<std::uint64_t> RecordedTrack::back(std::uint64_t frames) {
    std::uint64_t left = frames;
    while (left > m_index) {
        const std::uint64_t here = m_index;
        TELETA_TRY(const bool any, m_reader.previous(m_block));
        if (!any)
            break;
        left -= here;
        m_index = m_block.frames();
        m_skipped = false;
    }
    const std::uint64_t last = std::min<std::uint64_t>(left, m_index);
    m_index -= last;
    m_atEnd = m_index == m_block.frames();
    return frames - left + last;
}

core::Expected<void> RecordedTrack::nextBlock() {
    m_skipped = false;
    for (;;) {
        const core::Expected<bool> any = m_reader.next(m_block);
        const bool isDamage = !any && m_reader.canGoOn() && any.error().kind == core::ErrorKind::badInput;
        if (isDamage) {
            ++m_damaged;
            m_skipped = true;
            continue;
        }
        m_atEnd = !any || !*any;
        m_index = m_atEnd ? m_block.frames() : 0;
        TELETA_CHECK(any);
        return {};
    }
}

} // namespace teleta::replay
