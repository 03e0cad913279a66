// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/study_schema.h"

#include <QCoreApplication>
#include <QSqlError>
#include <QSqlQuery>
#include <QStringList>

#include <string>
#include <vector>

namespace teleta::study {

namespace {

struct SchemaText {
    Q_DECLARE_TR_FUNCTIONS(StudySchema)
};

/// Step i leads from schema i to schema i + 1.
const std::vector<QStringList>& steps() {
    static const std::vector<QStringList> kSteps = {
        {QStringLiteral(
             "CREATE TABLE study (one INTEGER PRIMARY KEY CHECK (one = 1), protocol TEXT NOT NULL, "
             "seed TEXT NOT NULL, mode TEXT NOT NULL CHECK (mode IN ('run', 'pilot', 'simulated')), "
             "planned_participants INTEGER NOT NULL, lapses REAL NOT NULL, created_utc TEXT NOT NULL, "
             "app_version TEXT NOT NULL)"),
         QStringLiteral("CREATE TABLE participant (key INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, "
                        "enrolment INTEGER NOT NULL UNIQUE CHECK (enrolment >= 0))"),
         QStringLiteral("CREATE TABLE session (key INTEGER PRIMARY KEY, "
                        "participant INTEGER NOT NULL REFERENCES participant (key), id TEXT NOT NULL, "
                        "plan_index INTEGER NOT NULL, seed TEXT NOT NULL, "
                        "finished INTEGER NOT NULL DEFAULT 0 CHECK (finished IN (0, 1)), "
                        "UNIQUE (participant, id), UNIQUE (participant, plan_index))"),
         QStringLiteral(
             "CREATE TABLE trial (key INTEGER PRIMARY KEY, session INTEGER NOT NULL REFERENCES session "
             "(key), "
             "phase TEXT NOT NULL CHECK (phase IN ('practice', 'test')), trial INTEGER NOT NULL, "
             "attempt INTEGER NOT NULL, trial_in_block INTEGER NOT NULL, repetition INTEGER NOT NULL, "
             "stimulus INTEGER NOT NULL, response INTEGER, outcome TEXT NOT NULL CHECK (outcome IN "
             "('correct', "
             "'incorrect', 'timeout', 'aborted', 'device_error')), response_time_s REAL, "
             "response_time_offset_s REAL, response_device TEXT, response_key TEXT, n_replays INTEGER NOT "
             "NULL, "
             "early_presses INTEGER NOT NULL, onset_s REAL NOT NULL, duration_s REAL NOT NULL, "
             "device_latency_ms REAL, device_faults INTEGER NOT NULL, time_utc TEXT NOT NULL, "
             "UNIQUE (session, phase, trial, attempt), UNIQUE (session, phase, trial_in_block))")},
        {QStringLiteral("ALTER TABLE study ADD COLUMN stimulus_set_sha256 TEXT NOT NULL DEFAULT ''")}};
    return kSteps;
}

} // namespace

int currentSchema() {
    return static_cast<int>(steps().size());
}

core::Expected<void> migrateSchema(QSqlDatabase& database, const std::string& file) {
    QSqlQuery query(database);
    const auto failed = [&](core::ErrorKind kind, const QString& message) {
        database.rollback();
        return core::Unexpected(core::Error{kind, message.toStdString(), {}, {file}});
    };
    if (!query.exec(QStringLiteral("PRAGMA user_version")) || !query.next())
        return failed(core::ErrorKind::badInput,
                      SchemaText::tr("this is no study: %1").arg(query.lastError().databaseText()));
    const int found = query.value(0).toInt();
    query.finish();
    if (found > currentSchema())
        return failed(core::ErrorKind::refused,
                      SchemaText::tr("a newer program made this study (schema %1, this one knows %2)")
                          .arg(found)
                          .arg(currentSchema()));
    for (int schema = found; schema < currentSchema(); ++schema) {
        bool done = database.transaction();
        for (const QString& statement : steps()[static_cast<std::size_t>(schema)])
            done = done && query.exec(statement);
        done = done && query.exec(QStringLiteral("PRAGMA user_version = %1").arg(schema + 1));
        if (!done || !database.commit())
            return failed(core::ErrorKind::ioFailed,
                          SchemaText::tr("cannot write the study: %1")
                              .arg((done ? database.lastError() : query.lastError()).databaseText()));
    }
    return {};
}

} // namespace teleta::study
