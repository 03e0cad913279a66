// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/start/recent_names.h"

#include "app/common/duration_text.h"
#include "backend/recording/recording.h"
#include "widgets/base/background.h"

#include <QFileInfo>

#include <algorithm>

namespace teleta::console {

core::Expected<chrome::RecentName> nameOfRecording(const QString& path) {
    TELETA_TRY(const recording::Recording opened, recording::Recording::open(path.toStdString()));
    const recording::RecordingHead& head = opened.head();
    std::string title = head.scene;
    std::int64_t end_ns = head.start_ns;
    for (std::size_t stream = 0; stream < opened.streams().size(); ++stream) {
        if (title.empty())
            title = opened.streams()[stream].source;
        TELETA_TRY(const auto extent, opened.extent(stream));
        if (extent)
            end_ns = std::max(end_ns, extent->last_ns);
    }
    const QDateTime start = opened.utcOf(head.start_ns).toLocalTime();
    const QString length = app::durationText(opened.time_s(end_ns));
    const auto about = [&](const char* form) {
        return start.isValid() ? start.toString(QLatin1String(form)) + QStringLiteral(", ") + length : length;
    };
    return chrome::RecentName{.title = title.empty() ? QFileInfo(path).completeBaseName()
                                                     : QString::fromStdString(title),
                              .about = about("yyyy-MM-dd HH:mm"),
                              .exact = about("yyyy-MM-dd HH:mm:ss")};
}

void RecentFileNames::ask(const QStringList& paths) {
    for (const QString& path : paths) {
        if (!path.endsWith(QLatin1String(".teleta"), Qt::CaseInsensitive) || m_asked.contains(path))
            continue;
        m_asked.insert(path);
        ++m_awaited;
        base::runInBackground(
            this, [path] { return nameOfRecording(path); },
            [this, path](const core::Expected<chrome::RecentName>& name) {
                if (name)
                    m_names.insert(path, *name);
                if (--m_awaited == 0)
                    emit changed();
            });
    }
}

} // namespace teleta::console
