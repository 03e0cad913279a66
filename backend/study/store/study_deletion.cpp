// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/study_deletion.h"

#include "backend/core/failure.h"
#include "backend/study/store/store_values.h"
#include "backend/study/store/study_connection.h"
#include "backend/study/store/trial_journal.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::study {

namespace {

struct DeletionText {
    Q_DECLARE_TR_FUNCTIONS(StudyStore)
};

} // namespace

core::Expected<Deletion> deleteParticipant(StudyStore& store, const Participant& participant,
                                           const std::string& reason, const QDateTime& now) {
    if (store.isReadOnly())
        return core::failed(core::ErrorKind::refused, DeletionText::tr("the study is open for reading only"),
                            DeletionText::tr("a folder that can be written to"), {store.shownName()});
    TELETA_TRY(const ParticipantClaim held, store.claim(participant));
    StudyConnection connection(store.location());
    TELETA_CHECK(connection.open(StudyConnection::Purpose::open));
    // Otherwise the file keeps the bytes of deleted rows until others need the room.
    if (!connection.isServer())
        TELETA_CHECK(connection.run(QStringLiteral("PRAGMA secure_delete = ON")));
    Deletion deletion{.enrolment = participant.enrolment, .reason = reason, .time = now.toUTC()};
    std::vector<long long> keys;
    const QString sessionsOf = QStringLiteral("(SELECT key FROM session WHERE participant = ?)");
    const core::Expected<void> deleted = connection.inTransaction([&]() -> core::Expected<void> {
        TELETA_TRY(auto sessions,
                   connection.run(QStringLiteral("SELECT key FROM session WHERE participant = ?"),
                                  {participant.key}));
        while (sessions.next())
            keys.push_back(sessions.value(0).toLongLong());
        sessions.finish();
        TELETA_TRY(auto trials,
                   connection.run(QStringLiteral("SELECT COUNT(*) FROM trial WHERE session IN ") + sessionsOf,
                                  {participant.key}));
        deletion.sessions = keys.size();
        deletion.trials = trials.next() ? count(trials.value(0)) : 0;
        trials.finish();
        for (const QString& statement : {QStringLiteral("DELETE FROM answer WHERE participant = ?"),
                                         QStringLiteral("DELETE FROM note WHERE session IN ") + sessionsOf,
                                         QStringLiteral("DELETE FROM trial WHERE session IN ") + sessionsOf,
                                         QStringLiteral("DELETE FROM session WHERE participant = ?")}) {
            TELETA_CHECK(connection.run(statement, {participant.key}));
        }
        TELETA_TRY(auto gone,
                   connection.run(QStringLiteral("DELETE FROM participant WHERE key = ? AND enrolment = ?"),
                                  {participant.key, sqlValue(participant.enrolment)}));
        if (gone.numRowsAffected() != 1)
            return core::failed(core::ErrorKind::notFound,
                                DeletionText::tr("the study has no participant \"%1\"")
                                    .arg(QString::fromStdString(participant.id)),
                                {}, {store.shownName()});
        TELETA_CHECK(
            connection.run(QStringLiteral("INSERT INTO deletion (enrolment, sessions, trials, reason, "
                                          "time_utc) VALUES (?, ?, ?, ?, ?)"),
                           {sqlValue(deletion.enrolment), sqlValue(deletion.sessions),
                            sqlValue(deletion.trials), QString::fromStdString(reason), timeText(now)}));
        return {};
    });
    TELETA_CHECK(deleted);
    for (const long long key : keys)
        TELETA_CHECK(TrialJournal(store.folder(), key).remove());
    // The log may hold earlier versions of pages; while somebody reads it, it is cleared later.
    if (!connection.isServer())
        TELETA_CHECK(connection.run(QStringLiteral("PRAGMA wal_checkpoint(TRUNCATE)")));
    return deletion;
}

core::Expected<std::vector<Deletion>> deletions(const StudyStore& store) {
    StudyConnection connection(store.location());
    TELETA_CHECK(connection.open(StudyConnection::Purpose::read));
    TELETA_TRY(auto query,
               connection.run(QStringLiteral("SELECT enrolment, sessions, trials, reason, time_utc FROM "
                                             "deletion ORDER BY key")));
    std::vector<Deletion> all;
    while (query.next())
        all.push_back({count(query.value(0)), count(query.value(1)), count(query.value(2)),
                       stringOf(query.value(3)), timeOf(query.value(4).toString())});
    return all;
}

} // namespace teleta::study
