// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_track.h"

namespace teleta::replay {

RecordedTrack::RecordedTrack(const recording::Recording& recording, std::size_t stream)
    : m_reader(recording.reader(stream))
    , m_channels(recording.streams()[stream].channels()) {
}

core::Expected<void> RecordedTrack::seek(std::int64_t time_ns) {
    core::Expected<void> done = m_reader.seek(time_ns);
    m_atEnd = false;
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

core::Expected<void> RecordedTrack::nextBlock() {
    m_index = 0;
    for (;;) {
        const core::Expected<bool> any = m_reader.next(m_block);
        if (any) {
            m_atEnd = !*any;
            return {};
        }
        if (!m_reader.canGoOn() || any.error().kind != core::ErrorKind::badInput) {
            m_atEnd = true;
            return core::Unexpected(any.error());
        }
        ++m_damaged;
    }
}

} // namespace teleta::replay
