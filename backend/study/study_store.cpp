// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/study_store.h"

#include "backend/study/stimulus_set.h"
#include "backend/study/study_schema.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSqlError>
#include <QSqlQuery>
#include <QStringList>
#include <QUuid>
#include <QVariant>

#include <initializer_list>
#include <utility>

namespace teleta::study {

namespace {

struct StoreText {
    Q_DECLARE_TR_FUNCTIONS(StudyStore)
};

constexpr int kLongestId = 64;
constexpr int kWaitForOthers_ms = 10'000;

std::string fileIn(const std::string& folder) {
    return QDir(QString::fromStdString(folder)).filePath(QStringLiteral("study.sqlite")).toStdString();
}

QString timeText(const QDateTime& time) {
    return time.toUTC().toString(Qt::ISODateWithMs);
}

QDateTime timeOf(const QString& text) {
    return QDateTime::fromString(text, Qt::ISODateWithMs).toUTC();
}

QVariant number(std::size_t value) {
    return static_cast<qlonglong>(value);
}

template <typename Value>
QVariant orNull(const std::optional<Value>& value) {
    if constexpr (std::is_same_v<Value, double>)
        return value ? QVariant(*value) : QVariant(QMetaType(QMetaType::Double));
    else
        return value ? number(*value) : QVariant(QMetaType(QMetaType::LongLong));
}

QVariant orNull(const std::string& text) {
    return text.empty() ? QVariant(QMetaType(QMetaType::QString)) : QVariant(QString::fromStdString(text));
}

std::optional<double> optionalNumber(const QVariant& value) {
    return value.isNull() ? std::nullopt : std::optional(value.toDouble());
}

std::size_t count(const QVariant& value) {
    return static_cast<std::size_t>(value.toLongLong());
}

} // namespace

/// One named connection of Qt, closed and forgotten with the object.
class StudyStore::Connection {
public:
    explicit Connection(const std::string& path)
        : m_path(path)
        , m_name(QUuid::createUuid().toString())
        , database(QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name)) {
        database.setDatabaseName(QString::fromStdString(path));
        database.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(kWaitForOthers_ms));
    }
    ~Connection() {
        database.close();
        database = QSqlDatabase();
        QSqlDatabase::removeDatabase(m_name);
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    [[nodiscard]] core::Expected<void> open() {
        if (!database.open())
            return failed(StoreText::tr("cannot open the study: %1"), database.lastError());
        for (const char* pragma :
             {"PRAGMA journal_mode = WAL", "PRAGMA synchronous = FULL", "PRAGMA foreign_keys = ON"}) {
            QSqlQuery query(database);
            if (!query.exec(QString::fromLatin1(pragma)))
                return failed(StoreText::tr("cannot open the study: %1"), query.lastError());
        }
        return migrateSchema(database, m_path);
    }

    [[nodiscard]] core::Expected<QSqlQuery> run(const QString& sql,
                                                std::initializer_list<QVariant> values = {}) const {
        QSqlQuery query(database);
        query.setForwardOnly(true);
        bool done = query.prepare(sql);
        for (const QVariant& value : values)
            query.addBindValue(value);
        done = done && query.exec();
        if (!done)
            return failed(StoreText::tr("cannot use the study: %1"), query.lastError());
        return query;
    }

    /// SQLite's primary code says whose fault it is; extended codes have it in their low byte.
    [[nodiscard]] core::Unexpected failed(const QString& what, const QSqlError& error) const {
        constexpr int kConstraint = 19;
        constexpr int kNotADatabase = 26;
        constexpr int kCorrupt = 11;
        const int code = error.nativeErrorCode().toInt() & 0xFF;
        const core::ErrorKind kind = code == kConstraint                         ? core::ErrorKind::refused
                                     : code == kNotADatabase || code == kCorrupt ? core::ErrorKind::badInput
                                                                                 : core::ErrorKind::ioFailed;
        return core::Unexpected(
            core::Error{kind, what.arg(error.databaseText()).toStdString(), {}, {m_path}});
    }

    [[nodiscard]] core::Unexpected damaged() const {
        return core::Unexpected(core::Error{
            core::ErrorKind::badInput,
            StoreText::tr(
                "the study is damaged: a session or a trial has a number that its protocol does not have")
                .toStdString(),
            {},
            {m_path}});
    }

    [[nodiscard]] core::Unexpected refused(const QString& message, const QString& expected) const {
        return core::Unexpected(
            core::Error{core::ErrorKind::refused, message.toStdString(), expected.toStdString(), {m_path}});
    }

    [[nodiscard]] const std::string& path() const { return m_path; }

private:
    std::string m_path;
    QString m_name;

public:
    QSqlDatabase database;
};

StudyStore::StudyStore(std::string folder, std::unique_ptr<Connection> connection)
    : m_folder(std::move(folder))
    , m_connection(std::move(connection)) {
}
StudyStore::~StudyStore() = default;
StudyStore::StudyStore(StudyStore&&) noexcept = default;
StudyStore& StudyStore::operator=(StudyStore&&) noexcept = default;

core::Expected<StudyStore> StudyStore::create(const std::string& folder, const StudyHead& head) {
    const std::string path = fileIn(folder);
    if (!QDir().mkpath(QString::fromStdString(folder)))
        return core::Unexpected(
            core::Error{core::ErrorKind::ioFailed,
                        StoreText::tr("cannot make the folder of the study").toStdString(),
                        {},
                        {folder}});
    StudyStore store(folder, std::make_unique<Connection>(path));
    Connection& connection = *store.m_connection;
    if (const core::Expected<void> opened = connection.open(); !opened)
        return core::Unexpected(opened.error());
    // The row is unique, so that of two programs that make the same study only one does.
    const auto made =
        connection.run(QStringLiteral("INSERT INTO study VALUES (1, ?, ?, ?, ?, ?, ?, ?, ?)"),
                       {QString::fromStdString(head.protocol.source), QString::number(head.seed),
                        QString::fromLatin1(toString(head.mode)), number(head.plannedParticipants),
                        head.lapses, timeText(head.created), QString::fromStdString(head.appVersion),
                        QString::fromStdString(stimulusSetSha256(head.protocol))});
    if (!made && made.error().kind == core::ErrorKind::refused)
        return connection.refused(StoreText::tr("there is a study in this folder already"),
                                  StoreText::tr("a new folder, or to go on with the study"));
    if (!made)
        return core::Unexpected(made.error());
    if (const core::Expected<void> read = store.readHead(); !read)
        return core::Unexpected(read.error());
    return store;
}

core::Expected<StudyStore> StudyStore::open(const std::string& folder) {
    const std::string path = fileIn(folder);
    if (!QFileInfo::exists(QString::fromStdString(path)))
        return core::Unexpected(core::Error{core::ErrorKind::notFound,
                                            StoreText::tr("there is no study here").toStdString(),
                                            StoreText::tr("a folder with study.sqlite").toStdString(),
                                            {folder}});
    StudyStore store(folder, std::make_unique<Connection>(path));
    if (const core::Expected<void> opened = store.m_connection->open(); !opened)
        return core::Unexpected(opened.error());
    if (const core::Expected<void> read = store.readHead(); !read)
        return core::Unexpected(read.error());
    return store;
}

core::Expected<void> StudyStore::readHead() {
    auto query =
        m_connection->run(QStringLiteral("SELECT protocol, seed, mode, planned_participants, lapses, "
                                         "created_utc, app_version, stimulus_set_sha256 FROM study"));
    if (!query)
        return core::Unexpected(query.error());
    if (!query->next())
        return core::Unexpected(
            core::Error{core::ErrorKind::badInput,
                        StoreText::tr("the study was never completely made").toStdString(),
                        {},
                        {m_connection->path()}});
    core::Expected<Protocol> protocol =
        parseProtocol(query->value(0).toString().toStdString(), m_connection->path());
    if (!protocol)
        return core::Unexpected(protocol.error());
    m_head.protocol = std::move(*protocol);
    m_head.seed = query->value(1).toString().toULongLong();
    m_head.mode = modeOf(query->value(2).toString().toStdString()).value_or(Mode::run);
    m_head.plannedParticipants = count(query->value(3));
    m_head.lapses = query->value(4).toDouble();
    m_head.created = timeOf(query->value(5).toString());
    m_head.appVersion = query->value(6).toString().toStdString();
    m_head.stimulusSetSha256 = query->value(7).toString().toStdString();
    return {};
}

core::Expected<Participant> StudyStore::enrol(const std::string& id) {
    const QString text = QString::fromStdString(id);
    // Files have these words for no value and for all participants.
    static const QStringList kReserved{QStringLiteral("NA"), QStringLiteral("n/a"), QStringLiteral("NONE"),
                                       QStringLiteral("GROUP")};
    if (text.trimmed().isEmpty() || text.size() > kLongestId || kReserved.contains(text))
        return m_connection->refused(
            StoreText::tr("\"%1\" cannot name a participant").arg(text.left(kLongestId)),
            StoreText::tr("a text of 1 to %1 characters").arg(kLongestId));
    const auto made = m_connection->run(QStringLiteral("INSERT INTO participant (id, enrolment) SELECT ?, "
                                                       "COALESCE(MAX(enrolment) + 1, 0) FROM participant"),
                                        {text});
    if (!made && made.error().kind == core::ErrorKind::refused)
        return m_connection->refused(StoreText::tr("the participant \"%1\" is enrolled already").arg(text),
                                     StoreText::tr("another name"));
    if (!made)
        return core::Unexpected(made.error());
    auto query =
        m_connection->run(QStringLiteral("SELECT key, enrolment FROM participant WHERE id = ?"), {text});
    if (!query)
        return core::Unexpected(query.error());
    query->next();
    return Participant{query->value(0).toLongLong(), id, count(query->value(1))};
}

core::Expected<std::vector<Participant>> StudyStore::participants() const {
    auto query =
        m_connection->run(QStringLiteral("SELECT key, id, enrolment FROM participant ORDER BY enrolment"));
    if (!query)
        return core::Unexpected(query.error());
    std::vector<Participant> all;
    while (query->next())
        all.push_back(
            {query->value(0).toLongLong(), query->value(1).toString().toStdString(), count(query->value(2))});
    return all;
}

core::Expected<SessionRecord> StudyStore::beginSession(const Participant& participant, std::size_t planIndex,
                                                       const PlannedSession& plan, const QDateTime& now) {
    const QString second = now.toUTC().toString(QStringLiteral("yyyyMMdd'T'HHmmss"));
    for (int sameSecond = 1;; ++sameSecond) {
        core::Expected<std::vector<SessionRecord>> known = sessions(participant);
        if (!known)
            return core::Unexpected(known.error());
        bool taken = false;
        const QString id = sameSecond == 1 ? second : QStringLiteral("%1x%2").arg(second).arg(sameSecond);
        for (SessionRecord& session : *known) {
            if (session.planIndex == planIndex)
                return std::move(session);
            taken = taken || session.id == id.toStdString();
        }
        if (taken)
            continue;
        const auto made = m_connection->run(
            QStringLiteral("INSERT INTO session (participant, id, plan_index, seed) VALUES (?, ?, ?, ?)"),
            {participant.key, id, number(planIndex), QString::number(plan.seed)});
        if (made)
            return SessionRecord{made->lastInsertId().toLongLong(), id.toStdString(), planIndex, false};
        // Another station may just have begun this session or taken this name; the next round sees it.
        if (made.error().kind != core::ErrorKind::refused)
            return core::Unexpected(made.error());
    }
}

core::Expected<void> StudyStore::finishSession(const SessionRecord& session) {
    const auto done =
        m_connection->run(QStringLiteral("UPDATE session SET finished = 1 WHERE key = ?"), {session.key});
    if (!done)
        return core::Unexpected(done.error());
    return {};
}

core::Expected<std::vector<SessionRecord>> StudyStore::sessions(const Participant& participant) const {
    auto query = m_connection->run(
        QStringLiteral(
            "SELECT key, id, plan_index, finished FROM session WHERE participant = ? ORDER BY plan_index"),
        {participant.key});
    if (!query)
        return core::Unexpected(query.error());
    const std::size_t planned = planSessions(m_head.protocol, m_head.seed, participant.enrolment).size();
    std::vector<SessionRecord> all;
    while (query->next()) {
        all.push_back({query->value(0).toLongLong(), query->value(1).toString().toStdString(),
                       count(query->value(2)), query->value(3).toInt() != 0});
        if (all.back().planIndex >= planned)
            return m_connection->damaged();
    }
    return all;
}

core::Expected<void> StudyStore::keepTrial(const SessionRecord& session, const TrialResult& result,
                                           const QDateTime& now) {
    const auto kept = m_connection->run(
        QStringLiteral(
            "INSERT INTO trial (session, phase, trial, attempt, trial_in_block, repetition, stimulus, "
            "response, outcome, response_time_s, response_time_offset_s, response_device, response_key, "
            "n_replays, early_presses, onset_s, duration_s, device_latency_ms, device_faults, time_utc) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        {session.key,
         QString::fromLatin1(toString(result.planned.phase)),
         number(result.planned.trial),
         number(result.planned.attempt),
         number(result.trialInBlock),
         number(result.planned.repetition),
         number(result.planned.stimulus),
         orNull(result.response),
         QString::fromLatin1(toString(result.outcome)),
         orNull(result.responseTime_s),
         orNull(result.responseTimeOffset_s),
         orNull(result.responseDevice),
         orNull(result.responseKey),
         number(result.replays),
         number(result.earlyPresses),
         result.onset_s,
         result.duration_s,
         orNull(result.deviceLatency_ms),
         number(result.deviceFaults),
         timeText(now)});
    if (!kept && kept.error().kind == core::ErrorKind::refused)
        return m_connection->refused(StoreText::tr("this trial is kept already"),
                                     StoreText::tr("each attempt of a trial once"));
    if (!kept)
        return core::Unexpected(kept.error());
    return {};
}

core::Expected<std::vector<StoredTrial>> StudyStore::trials(const SessionRecord& session) const {
    auto query = m_connection->run(
        QStringLiteral(
            "SELECT phase, trial, attempt, trial_in_block, repetition, stimulus, response, outcome, "
            "response_time_s, response_time_offset_s, response_device, response_key, n_replays, "
            "early_presses, onset_s, duration_s, device_latency_ms, device_faults, time_utc FROM trial "
            "WHERE session = ? ORDER BY key"),
        {session.key});
    if (!query)
        return core::Unexpected(query.error());
    // The tasks come in the same order for everybody.
    const std::vector<PlannedSession> plan = planSessions(m_head.protocol, m_head.seed, 0);
    if (session.planIndex >= plan.size())
        return m_connection->damaged();
    const std::size_t patterns = m_head.protocol.tasks[plan[session.planIndex].task].patterns.size();
    std::vector<StoredTrial> all;
    while (query->next()) {
        const auto text = [&](int column) { return query->value(column).toString().toStdString(); };
        StoredTrial trial;
        TrialResult& result = trial.result;
        result.planned = {phaseOf(text(0)).value_or(Phase::test), count(query->value(1)),
                          count(query->value(4)), count(query->value(2)), count(query->value(5))};
        result.trialInBlock = count(query->value(3));
        if (!query->value(6).isNull())
            result.response = count(query->value(6));
        if (result.planned.stimulus >= patterns || result.response.value_or(0) >= patterns)
            return m_connection->damaged();
        result.outcome = outcomeOf(text(7)).value_or(Outcome::aborted);
        result.responseTime_s = optionalNumber(query->value(8));
        result.responseTimeOffset_s = optionalNumber(query->value(9));
        result.responseDevice = text(10);
        result.responseKey = text(11);
        result.replays = count(query->value(12));
        result.earlyPresses = count(query->value(13));
        result.onset_s = query->value(14).toDouble();
        result.duration_s = query->value(15).toDouble();
        result.deviceLatency_ms = optionalNumber(query->value(16));
        result.deviceFaults = count(query->value(17));
        trial.time = timeOf(query->value(18).toString());
        all.push_back(std::move(trial));
    }
    return all;
}

} // namespace teleta::study
