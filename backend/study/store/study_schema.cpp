// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/study_schema.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QSqlError>
#include <QSqlQuery>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

namespace {

struct SchemaText {
    Q_DECLARE_TR_FUNCTIONS(StudySchema)
};

/// Step i leads from schema i to schema i + 1. AUTOKEY and FLOAT stand for an auto-incremented key and a
/// double in either database.
const std::vector<QStringList>& steps() {
    static const std::vector<QStringList> kSteps = {
        {QStringLiteral(
             "CREATE TABLE study (one INTEGER PRIMARY KEY CHECK (one = 1), protocol TEXT NOT NULL, "
             "seed TEXT NOT NULL, mode TEXT NOT NULL CHECK (mode IN ('run', 'pilot', 'simulated')), "
             "planned_participants INTEGER NOT NULL, lapses FLOAT NOT NULL, created_utc TEXT NOT NULL, "
             "app_version TEXT NOT NULL)"),
         QStringLiteral("CREATE TABLE participant (key AUTOKEY, id TEXT NOT NULL UNIQUE, "
                        "enrolment INTEGER NOT NULL UNIQUE CHECK (enrolment >= 0))"),
         QStringLiteral("CREATE TABLE session (key AUTOKEY, "
                        "participant INTEGER NOT NULL REFERENCES participant (key), id TEXT NOT NULL, "
                        "plan_index INTEGER NOT NULL, seed TEXT NOT NULL, "
                        "finished INTEGER NOT NULL DEFAULT 0 CHECK (finished IN (0, 1)), "
                        "UNIQUE (participant, id), UNIQUE (participant, plan_index))"),
         QStringLiteral(
             "CREATE TABLE trial (key AUTOKEY, session INTEGER NOT NULL REFERENCES session (key), "
             "phase TEXT NOT NULL CHECK (phase IN ('practice', 'test')), trial INTEGER NOT NULL, "
             "attempt INTEGER NOT NULL, trial_in_block INTEGER NOT NULL, repetition INTEGER NOT NULL, "
             "stimulus INTEGER NOT NULL, response INTEGER, outcome TEXT NOT NULL CHECK (outcome IN "
             "('correct', 'incorrect', 'timeout', 'aborted', 'device_error')), response_time_s FLOAT, "
             "response_time_offset_s FLOAT, response_device TEXT, response_key TEXT, n_replays INTEGER NOT "
             "NULL, early_presses INTEGER NOT NULL, onset_s FLOAT NOT NULL, duration_s FLOAT NOT NULL, "
             "device_latency_ms FLOAT, device_faults INTEGER NOT NULL, time_utc TEXT NOT NULL, "
             "UNIQUE (session, phase, trial, attempt), UNIQUE (session, phase, trial_in_block))")},
        {QStringLiteral("ALTER TABLE study ADD COLUMN stimulus_set_sha256 TEXT NOT NULL DEFAULT ''")},
        // Answers of a participant as a whole have no session, and UNIQUE treats NULLs as different.
        {QStringLiteral("CREATE TABLE answer (key AUTOKEY, "
                        "participant INTEGER NOT NULL REFERENCES participant (key), "
                        "session INTEGER REFERENCES session (key), questionnaire TEXT NOT NULL, "
                        "item TEXT NOT NULL, value TEXT, time_utc TEXT NOT NULL)"),
         QStringLiteral("CREATE UNIQUE INDEX answer_once_a_session ON answer (session, questionnaire, item) "
                        "WHERE session IS NOT NULL"),
         QStringLiteral("CREATE UNIQUE INDEX answer_once ON answer (participant, questionnaire, item) "
                        "WHERE session IS NULL")},
        {QStringLiteral("ALTER TABLE trial ADD COLUMN frame_write_ms FLOAT"),
         QStringLiteral("ALTER TABLE trial ADD COLUMN frames_missed INTEGER"),
         QStringLiteral("CREATE TABLE note (key AUTOKEY, session INTEGER NOT NULL REFERENCES session (key), "
                        "text TEXT NOT NULL, time_utc TEXT NOT NULL)")},
        {QStringLiteral("CREATE TABLE stimulus (id TEXT PRIMARY KEY, file TEXT NOT NULL, "
                        "pattern TEXT NOT NULL)")},
        {QStringLiteral("ALTER TABLE trial ADD COLUMN track TEXT"),
         QStringLiteral("ALTER TABLE trial ADD COLUMN level FLOAT"),
         QStringLiteral("ALTER TABLE trial ADD COLUMN target INTEGER"),
         QStringLiteral("ALTER TABLE trial ADD COLUMN trigger_ms FLOAT"),
         QStringLiteral("ALTER TABLE trial ADD COLUMN recording TEXT"),
         QStringLiteral("ALTER TABLE trial ADD COLUMN recording_s FLOAT"),
         QStringLiteral("ALTER TABLE study ADD COLUMN observer TEXT NOT NULL DEFAULT ''")},
        {QStringLiteral(
            "CREATE TABLE deletion (key AUTOKEY, enrolment INTEGER NOT NULL, sessions INTEGER NOT NULL, "
            "trials INTEGER NOT NULL, reason TEXT NOT NULL, time_utc TEXT NOT NULL)")},
        {QStringLiteral("ALTER TABLE trial ADD COLUMN device_latency_spread_ms FLOAT")}};
    return kSteps;
}

bool isServer(const QSqlDatabase& database) {
    return database.driverName() == QStringLiteral("QPSQL");
}

QString inDialectOf(const QSqlDatabase& database, QString statement) {
    return statement
        .replace(QStringLiteral("AUTOKEY"),
                 isServer(database) ? QStringLiteral("BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY")
                                    : QStringLiteral("INTEGER PRIMARY KEY"))
        .replace(QStringLiteral("FLOAT"),
                 isServer(database) ? QStringLiteral("DOUBLE PRECISION") : QStringLiteral("REAL"));
}

/// One migration, in a transaction that others wait for.
class Migration {
public:
    explicit Migration(QSqlDatabase& database)
        : m_database(database)
        , m_query(database) {}
    ~Migration() {
        if (m_begun)
            (void)m_query.exec(QStringLiteral("ROLLBACK"));
    }
    Migration(const Migration&) = delete;
    Migration& operator=(const Migration&) = delete;

    /// The schema of the database; empty when it cannot be read.
    std::optional<int> begin() {
        const bool server = isServer(m_database);
        m_begun = m_query.exec(server ? QStringLiteral("BEGIN") : QStringLiteral("BEGIN IMMEDIATE"));
        // Any number that all versions of the program share.
        const bool ready =
            m_begun &&
            (!server ||
             (m_query.exec(QStringLiteral("SELECT pg_advisory_xact_lock(7305)")) &&
              m_query.exec(QStringLiteral("CREATE TABLE IF NOT EXISTS schema_version (version INTEGER)"))));
        const QString version = server
                                    ? QStringLiteral("SELECT COALESCE(MAX(version), 0) FROM schema_version")
                                    : QStringLiteral("PRAGMA user_version");
        if (!ready || !m_query.exec(version) || !m_query.next())
            return std::nullopt;
        const int found = m_query.value(0).toInt();
        m_query.finish();
        return found;
    }

    bool step(int schema) {
        bool done = true;
        for (const QString& statement : steps()[static_cast<std::size_t>(schema)])
            done = done && m_query.exec(inDialectOf(m_database, statement));
        const QString version = isServer(m_database)
                                    ? QStringLiteral("INSERT INTO schema_version VALUES (%1)")
                                    : QStringLiteral("PRAGMA user_version = %1");
        return done && m_query.exec(version.arg(schema + 1));
    }

    bool commit() {
        m_begun = !m_query.exec(QStringLiteral("COMMIT"));
        return !m_begun;
    }

    [[nodiscard]] QSqlError lastError() const { return m_query.lastError(); }

private:
    QSqlDatabase& m_database;
    QSqlQuery m_query;
    bool m_begun = false;
};

} // namespace

int currentSchema() {
    return static_cast<int>(steps().size());
}

core::Expected<void> migrateSchema(QSqlDatabase& database, const std::string& name,
                                   const std::function<core::ErrorKind(const QSqlError&)>& kindOf) {
    const auto refused = [&](core::ErrorKind kind, const QString& message) {
        return core::failed(kind, message, {}, {name});
    };
    const auto failed = [&](const QString& what, const QSqlError& error) {
        return refused(kindOf(error), what.arg(error.databaseText()));
    };
    const auto usable = [&](int found) -> core::Expected<void> {
        if (found < 0)
            return refused(core::ErrorKind::badInput,
                           SchemaText::tr("another program made this database (schema %1)").arg(found));
        if (found > currentSchema())
            return refused(core::ErrorKind::refused,
                           SchemaText::tr("a newer program made this study (schema %1, this one knows %2)")
                               .arg(found)
                               .arg(currentSchema()));
        return {};
    };
    if (!isServer(database)) {
        // Usually there is nothing to do, and nobody has to wait.
        QSqlQuery query(database);
        if (query.exec(QStringLiteral("PRAGMA user_version")) && query.next()) {
            const int found = query.value(0).toInt();
            if (found < 0 || found >= currentSchema())
                return usable(found);
        }
    }
    Migration migration(database);
    const std::optional<int> found = migration.begin();
    if (!found)
        return failed(SchemaText::tr("cannot read the study: %1"), migration.lastError());
    TELETA_CHECK(usable(*found));
    for (int schema = *found; schema < currentSchema(); ++schema) {
        if (!migration.step(schema))
            return failed(SchemaText::tr("cannot write the study: %1"), migration.lastError());
    }
    if (!migration.commit())
        return failed(SchemaText::tr("cannot write the study: %1"), migration.lastError());
    return {};
}

} // namespace teleta::study
