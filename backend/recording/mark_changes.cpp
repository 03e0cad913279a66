// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/mark_changes.h"

#include "backend/recording/recording_database.h"

#include <QSqlQuery>
#include <QString>

namespace teleta::recording {

core::Expected<void> writeMarkChanges(RecordingDatabase& database, std::span<const MarkChange> changes) {
    const QString kind = QString::fromLatin1(kMark);
    for (const MarkChange& change : changes) {
        const auto number = static_cast<double>(change.number);
        // A null string would be NULL.
        const QString note = QStringLiteral("") + QString::fromStdString(change.note.value_or(std::string()));
        if (change.note && !change.restored_ns) {
            TELETA_CHECK(
                database.run(QStringLiteral("UPDATE event SET text = ? WHERE kind = ? AND value = ?"),
                             {note, kind, number}));
            continue;
        }
        TELETA_CHECK(
            database.run(QStringLiteral("DELETE FROM event WHERE kind = ? AND value = ?"), {kind, number}));
        // A mark that is still there does not come twice.
        if (change.restored_ns)
            TELETA_CHECK(database.run(
                QStringLiteral("INSERT INTO event (time_ns, kind, text, value) VALUES (?, ?, ?, ?)"),
                {static_cast<qlonglong>(*change.restored_ns), kind, note, number}));
    }
    return {};
}

core::Expected<void> changeMarks(const std::string& path, std::span<const MarkChange> changes) {
    RecordingDatabase database(path);
    TELETA_CHECK(database.openForWriting());
    return database.inTransaction([&] { return writeMarkChanges(database, changes); });
}

} // namespace teleta::recording
