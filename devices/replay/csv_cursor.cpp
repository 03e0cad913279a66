// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/csv_cursor.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::replay {

core::Expected<CsvCursor> CsvCursor::open(const std::string& path, const core::ArrayLayout& layout) {
    TELETA_TRY(core::FrameFile file, core::FrameFile::open(path, layout));
    if (file.bytesTotal() == 0)
        return core::failed(
            core::ErrorKind::refused,
            QCoreApplication::translate("ReplayDevice", "only a file can be played, not a pipe"), {}, {path});
    return CsvCursor(std::move(file));
}

CsvCursor::CsvCursor(core::FrameFile file)
    : m_file(std::move(file))
    , m_values(m_file.layout().taxels()) {
}

core::Expected<bool> CsvCursor::read() {
    FramePlace place{.frame = m_next, .time_s = 0.0, .offset = m_file.offset(), .line = m_file.line()};
    const core::Expected<bool> any = m_file.next(place.time_s, m_values);
    if (any && *any) {
        m_place = place;
        if (m_next == 0)
            m_first = place;
        ++m_next;
    }
    return any;
}

core::Expected<void> CsvCursor::goTo(const FramePlace& place) {
    const core::Expected<void> done = m_file.seek(place.offset, place.line);
    if (done)
        m_next = place.frame;
    return done;
}

} // namespace teleta::replay
