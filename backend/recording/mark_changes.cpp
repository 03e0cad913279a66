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
        // A text that is empty is no text that is missing.
        const QString note = QStringLiteral("") + QString::fromStdString(change.note.value_or(std::string()));
        core::Expected<QSqlQuery> done;
        if (change.note && !change.restored_ns)
            done = database.run(QStringLiteral("UPDATE event SET text = ? WHERE kind = ? AND value = ?"),
                                {note, kind, number});
        else
            done = database.run(QStringLiteral("DELETE FROM event WHERE kind = ? AND value = ?"),
                                {kind, number});
        // One that is there still does not come twice.
        if (done && change.restored_ns)
            done = database.run(
                QStringLiteral("INSERT INTO event (time_ns, kind, text, value) VALUES (?, ?, ?, ?)"),
                {static_cast<qlonglong>(*change.restored_ns), kind, note, number});
        TELETA_CHECK(done);
    }
    return {};
}

core::Expected<void> changeMarks(const std::string& path, std::span<const MarkChange> changes) {
    RecordingDatabase database(path);
    if (const core::Expected<void> opened = database.openForWriting(); !opened)
        return opened;
    TELETA_CHECK(database.run(QStringLiteral("BEGIN IMMEDIATE")));
    core::Expected<void> done = writeMarkChanges(database, changes);
    if (done) {
        if (const auto committed = database.run(QStringLiteral("COMMIT")); !committed)
            done = core::Unexpected(committed.error());
    }
    if (!done)
        (void)database.run(QStringLiteral("ROLLBACK"));
    return done;
}

} // namespace teleta::recording
