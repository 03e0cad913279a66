// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/replay_cursor.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::replay {

core::Expected<ReplayCursor> ReplayCursor::open(const std::string& path, const core::ArrayLayout& layout) {
    core::Expected<core::FrameFile> file = core::FrameFile::open(path, layout);
    if (!file)
        return core::Unexpected(file.error());
    if (file->bytesTotal() == 0)
        return core::Unexpected(
            core::Error{core::ErrorKind::refused,
                        QCoreApplication::translate("ReplayDevice", "only a file can be played, not a pipe")
                            .toStdString(),
                        {},
                        {path}});
    return ReplayCursor(std::move(*file));
}

ReplayCursor::ReplayCursor(core::FrameFile file)
    : m_file(std::move(file))
    , m_values(m_file.layout().taxels()) {
}

core::Expected<bool> ReplayCursor::read() {
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

core::Expected<void> ReplayCursor::goTo(const FramePlace& place) {
    const core::Expected<void> done = m_file.seek(place.offset, place.line);
    if (done)
        m_next = place.frame;
    return done;
}

} // namespace teleta::replay
