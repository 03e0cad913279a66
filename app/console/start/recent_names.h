// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "widgets/chrome/recent_name.h"

#include <QObject>
#include <QSet>
#include <QStringList>

namespace teleta::console {

/// The name of a recording of this program: its scene or else its first source, local time of its start as
/// "2026-11-29 10:22", and its length up to its last frame. Error: as the reader of the file. Thread: any.
[[nodiscard]] core::Expected<chrome::RecentName> nameOfRecording(const QString& path);

/// Finds out what recordings that were opened before are called, in the background and once each. Other
/// files, and those that cannot be read, have none. Thread: GUI.
class RecentFileNames : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void ask(const QStringList& paths);
    [[nodiscard]] const chrome::RecentNames& names() const { return m_names; }

signals:
    /// All that was asked for is known.
    void changed();

private:
    chrome::RecentNames m_names;
    QSet<QString> m_asked;
    int m_awaited = 0;
};

} // namespace teleta::console
