// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/csv_track.h"

#include <algorithm>
#include <utility>

namespace teleta::replay {

CsvTrack::CsvTrack(CsvCursor cursor, const CsvRecording& recording, std::function<bool()> isInterrupted)
    : m_cursor(std::move(cursor))
    , m_recording(recording)
    , m_isInterrupted(std::move(isInterrupted)) {
}

core::Expected<void> CsvTrack::seek(std::int64_t time_ns) {
    return scan(m_recording.before(time_ns),
                [&](const FramePlace& place) { return m_recording.time_ns(place) >= time_ns; });
}

core::Expected<void> CsvTrack::advance() {
    const core::Expected<bool> any = m_cursor.read();
    m_atEnd = !any || !*any;
    m_canReadOn = any.has_value();
    TELETA_CHECK(any);
    return {};
}

core::Expected<std::uint64_t> CsvTrack::back(std::uint64_t frames) {
    const std::uint64_t here = m_cursor.place().frame + (m_atEnd ? 1 : 0);
    const std::uint64_t target = here - std::min(frames, here);
    if (target != here)
        TELETA_CHECK(scan(m_recording.index().atFrame(target),
                          [target](const FramePlace& place) { return place.frame >= target; }));
    return here - target;
}

/// Reads on until a frame is reached, or to the end; from a known place if that is nearer.
template <typename Reached>
core::Expected<void> CsvTrack::scan(const FramePlace& from, const Reached& reached) {
    const FramePlace& here = m_cursor.place();
    if (!m_canReadOn || here.frame < from.frame || reached(here))
        TELETA_CHECK(m_cursor.goTo(from));
    do {
        if (m_isInterrupted())
            return core::Unexpected(core::Error{core::ErrorKind::cancelled, {}, {}, {}});
        TELETA_CHECK(advance());
    } while (!m_atEnd && !reached(m_cursor.place()));
    return {};
}

} // namespace teleta::replay
