// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/recording_database.h"

#include "backend/core/data/input_file.h"
#include "backend/core/failure.h"
#include "backend/core/sqlite/foreign_database.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSqlError>
#include <QStringList>
#include <QUuid>

#include <chrono>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::recording {

namespace {

struct RecordingText {
    Q_DECLARE_TR_FUNCTIONS(Recording)
};

constexpr int kApplicationId = 0x54544C41; // "TTLA"
constexpr int kWaitForOthers_ms = 5000;
/// SQLite does not wait for readers by itself when it merges the log.
constexpr int kLooksForReaders = 50;
constexpr std::chrono::milliseconds kBetweenLooks{20};

/// Step i leads from schema i to schema i + 1.
const std::vector<QStringList>& steps() {
    static const std::vector<QStringList> kSteps = {
        {QStringLiteral("CREATE TABLE recording (one INTEGER PRIMARY KEY CHECK (one = 1), "
                        "app_version TEXT NOT NULL, scene TEXT NOT NULL, scene_text TEXT NOT NULL, "
                        "configuration TEXT NOT NULL, start_ns INTEGER NOT NULL)"),
         QStringLiteral("CREATE TABLE anchor (time_ns INTEGER NOT NULL, utc TEXT NOT NULL)"),
         QStringLiteral("CREATE TABLE stream (key INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, "
                        "kind TEXT NOT NULL, type TEXT NOT NULL, source TEXT NOT NULL, shape TEXT NOT NULL, "
                        "unit TEXT NOT NULL, rate_hz REAL NOT NULL, details TEXT NOT NULL)"),
         QStringLiteral("CREATE TABLE stream_column (stream INTEGER NOT NULL REFERENCES stream (key), "
                        "number INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL, "
                        "PRIMARY KEY (stream, number)) WITHOUT ROWID"),
         QStringLiteral("CREATE TABLE block (key INTEGER PRIMARY KEY, "
                        "stream INTEGER NOT NULL REFERENCES stream (key), first_ns INTEGER NOT NULL, "
                        "last_ns INTEGER NOT NULL, frames INTEGER NOT NULL, width INTEGER NOT NULL, "
                        "height INTEGER NOT NULL, discontinuity INTEGER NOT NULL, time_ns BLOB NOT NULL, "
                        "source_time_s BLOB NOT NULL, data BLOB NOT NULL)"),
         QStringLiteral("CREATE INDEX block_by_time ON block (stream, first_ns)"),
         QStringLiteral("CREATE TABLE event (key INTEGER PRIMARY KEY, time_ns INTEGER NOT NULL, "
                        "kind TEXT NOT NULL, text TEXT NOT NULL, value REAL NOT NULL)")}};
    return kSteps;
}

/// Files that this process writes. Closing any descriptor of a file drops all locks that the process holds on
/// it, including SQLite's (POSIX): another process could then take the file for an interrupted recording.
/// Only SQLite opens such a file. Thread: any.
class WrittenFiles {
public:
    void add(const QString& path) {
        const std::scoped_lock lock(m_mutex);
        m_paths.insert(path);
    }
    void remove(const QString& path) {
        const std::scoped_lock lock(m_mutex);
        m_paths.erase(path);
    }
    [[nodiscard]] bool contains(const QString& path) {
        const std::scoped_lock lock(m_mutex);
        return m_paths.contains(path);
    }

private:
    std::mutex m_mutex;
    std::set<QString> m_paths; ///< guarded by m_mutex; canonical
};

WrittenFiles& writtenFiles() {
    static WrittenFiles files;
    return files;
}

QString reasonOf(const QSqlError& error) {
    return error.databaseText().isEmpty() ? error.driverText().simplified()
                                          : error.databaseText().simplified();
}

} // namespace

RecordingDatabase::RecordingDatabase(std::string path)
    : m_path(std::move(path))
    , m_name(QUuid::createUuid().toString())
    , m_database(QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name)) {
}

RecordingDatabase::~RecordingDatabase() {
    close();
    m_database = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

bool RecordingDatabase::beginsLikeOne(QIODevice& file) {
    static const QByteArray kMagic("SQLite format 3\0", 16);
    return file.read(kMagic.size()) == kMagic;
}

int RecordingDatabase::currentSchema() {
    return static_cast<int>(steps().size());
}

void RecordingDatabase::close() {
    m_database.close();
    if (!m_written.isEmpty())
        writtenFiles().remove(std::exchange(m_written, {}));
}

bool RecordingDatabase::isWrittenHere(const std::string& path) {
    return writtenFiles().contains(QFileInfo(QString::fromStdString(path)).canonicalFilePath());
}

core::Expected<void> RecordingDatabase::connect(const QString& options) {
    close();
    m_database.setDatabaseName(QString::fromStdString(m_path));
    m_database.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(kWaitForOthers_ms) + options);
    if (!m_database.open())
        return failed(m_database.lastError());
    return core::distrustSchema(m_database, m_path);
}

core::Expected<void> RecordingDatabase::create() {
    QFile file(QString::fromStdString(m_path));
    // Exclusively, so that no recording is overwritten; for its owner alone, since people's touches are in
    // it.
    if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly,
                   QFileDevice::ReadOwner | QFileDevice::WriteOwner)) {
        if (file.exists())
            return core::failed(core::ErrorKind::refused,
                                RecordingText::tr("a file of this name already exists"),
                                RecordingText::tr("a new name"), {m_path});
        return core::failed(core::ErrorKind::ioFailed,
                            RecordingText::tr("the recording cannot be written: %1").arg(file.errorString()),
                            RecordingText::tr("a writable folder"), {m_path});
    }
    file.close();
    // The schema is created before the write-ahead log, so that the file itself tells what it is.
    core::Expected<void> made =
        connect({}).and_then([&] { return migrate(0); }).and_then([&]() -> core::Expected<void> {
            for (const QString& setting :
                 {QStringLiteral("PRAGMA journal_mode = WAL"), QStringLiteral("PRAGMA synchronous = FULL")}) {
                TELETA_CHECK(run(setting));
            }
            return {};
        });
    if (!made) {
        close();
        QFile::remove(QString::fromStdString(m_path));
        return made;
    }
    m_written = QFileInfo(QString::fromStdString(m_path)).canonicalFilePath();
    writtenFiles().add(m_written);
    return made;
}

core::Expected<void> RecordingDatabase::checkFile() const {
    if (isWrittenHere(m_path))
        return {};
    QFile file(QString::fromStdString(m_path));
    TELETA_CHECK(core::requireFile(m_path));
    if (!file.open(QIODevice::ReadOnly))
        return core::failed(core::ErrorKind::ioFailed, file.errorString(), {}, {m_path});
    if (!beginsLikeOne(file))
        return core::failed(core::ErrorKind::badInput, RecordingText::tr("this is not a recording"),
                            RecordingText::tr("a recording of this program"), {m_path});
    return {};
}

core::Expected<void> RecordingDatabase::checkKind(int& schema) {
    TELETA_TRY(auto kind, run(QStringLiteral("PRAGMA application_id")));
    if (!kind.next() || kind.value(0).toInt() != kApplicationId)
        return core::failed(core::ErrorKind::badInput,
                            RecordingText::tr("this is an SQLite database, but not a recording"),
                            RecordingText::tr("a recording of this program"), {m_path});
    TELETA_TRY(auto version, run(QStringLiteral("PRAGMA user_version")));
    schema = version.next() ? version.value(0).toInt() : 0;
    if (schema > currentSchema())
        return core::failed(
            core::ErrorKind::badInput,
            RecordingText::tr("the recording was made by a newer version of the program (format %1)")
                .arg(schema),
            RecordingText::tr("format %1 or older").arg(currentSchema()), {m_path});
    if (schema < 1)
        return damaged(RecordingText::tr("its format version is missing"));
    return {};
}

/// Merges the log of an interrupted recording, since people copy the file alone. Does nothing if that is not
/// possible, and does not wait for files that are being recorded or read.
void RecordingDatabase::foldLog() {
    const QString path = QString::fromStdString(m_path);
    if (isWrittenHere(m_path) || !QFile::exists(path + QStringLiteral("-wal")) ||
        !QFileInfo(path).isWritable() || !QFileInfo(QFileInfo(path).path()).isWritable())
        return;
    int schema = 0;
    if (connect({}) && run(QStringLiteral("PRAGMA busy_timeout = 0")) && checkKind(schema))
        (void)run(QStringLiteral("PRAGMA journal_mode = DELETE"));
    close();
}

core::Expected<void> RecordingDatabase::openForReading() {
    int schema = 0;
    core::Expected<void> opened = checkFile()
                                      .and_then([&]() -> core::Expected<void> {
                                          foldLog();
                                          return connect(QStringLiteral(";QSQLITE_OPEN_READONLY"));
                                      })
                                      .and_then([&] { return checkKind(schema); });
    // Killed while the file was created or completed: its transaction must be rolled back, which writes.
    if (!opened && opened.error().kind == core::ErrorKind::ioFailed &&
        QFile::exists(QString::fromStdString(m_path) + QStringLiteral("-journal")))
        opened = connect({}).and_then([&] { return checkKind(schema); });
    if (!opened && opened.error().kind == core::ErrorKind::ioFailed &&
        !QFileInfo(QFileInfo(QString::fromStdString(m_path)).path()).isWritable())
        opened.error().expected =
            RecordingText::tr(
                "a folder that can be written to: the recording was cut off and has to be completed")
                .toStdString();
    if (!opened || schema == currentSchema())
        return opened;
    return connect({}).and_then([&] { return migrate(schema); });
}

core::Expected<void> RecordingDatabase::openForWriting() {
    int schema = 0;
    const core::Expected<void> opened =
        checkFile().and_then([&] { return connect({}); }).and_then([&] { return checkKind(schema); });
    return opened && schema != currentSchema() ? migrate(schema) : opened;
}

core::Expected<void> RecordingDatabase::migrate(int from) {
    QStringList statements;
    for (std::size_t step = static_cast<std::size_t>(from); step < steps().size(); ++step)
        statements += steps()[step];
    statements << QStringLiteral("PRAGMA application_id = %1").arg(kApplicationId)
               << QStringLiteral("PRAGMA user_version = %1").arg(currentSchema());
    return inTransaction([&]() -> core::Expected<void> {
        for (const QString& statement : statements) {
            TELETA_CHECK(run(statement));
        }
        return {};
    });
}

core::Expected<void> RecordingDatabase::finish() {
    constexpr int kBusy = 5;
    const QString fold = QStringLiteral("PRAGMA journal_mode = DELETE");
    core::Expected<void> done;
    for (int look = 0; look < kLooksForReaders; ++look) {
        if (look > 0)
            std::this_thread::sleep_for(kBetweenLooks);
        QSqlQuery query(m_database);
        // A reader keeps the log alive; together with it the recording is complete.
        if (query.exec(fold) && query.next() && query.value(0).toString() == QLatin1String("delete"))
            break;
        const QSqlError error = query.lastError();
        if (error.isValid() && (error.nativeErrorCode().toInt() & 0xFF) != kBusy) {
            done = failed(error);
            break;
        }
    }
    close();
    return done;
}

core::Expected<QSqlQuery> RecordingDatabase::run(const QString& sql, const QVariantList& values) {
    QSqlQuery query(m_database);
    query.setForwardOnly(true);
    bool done = values.isEmpty() || query.prepare(sql);
    for (const QVariant& value : values)
        query.addBindValue(value);
    done = done && (values.isEmpty() ? query.exec(sql) : query.exec());
    if (!done)
        return failed(query.lastError());
    return query;
}

core::Expected<void> RecordingDatabase::inTransaction(const std::function<core::Expected<void>()>& work) {
    TELETA_CHECK(run(QStringLiteral("BEGIN IMMEDIATE")));
    const core::Expected<void> done =
        work().and_then([&] { return run(QStringLiteral("COMMIT")); }).map([](const QSqlQuery&) {});
    if (!done)
        (void)run(QStringLiteral("ROLLBACK"));
    return done;
}

core::Expected<QSqlQuery> RecordingDatabase::prepare(const QString& sql) {
    QSqlQuery query(m_database);
    query.setForwardOnly(true);
    if (!query.prepare(sql))
        return failed(query.lastError());
    return query;
}

core::Expected<void> RecordingDatabase::execute(QSqlQuery& query) {
    if (!query.exec())
        return failed(query.lastError());
    return {};
}

core::Unexpected RecordingDatabase::failed(const QSqlError& error) const {
    // The low byte of an extended code is SQLite's primary code, which tells the kind of failure.
    constexpr int kCorrupt = 11;
    constexpr int kFull = 13;
    constexpr int kNotADatabase = 26;
    const int code = error.nativeErrorCode().toInt() & 0xFF;
    if (code == kCorrupt || code == kNotADatabase)
        return damaged(reasonOf(error));
    if (code == kFull)
        return core::failed(core::ErrorKind::ioFailed, RecordingText::tr("the disk is full"), {}, {m_path});
    return core::failed(core::ErrorKind::ioFailed, reasonOf(error), {}, {m_path});
}

core::Unexpected RecordingDatabase::damaged(const QString& what) const {
    return core::failed(core::ErrorKind::badInput,
                        RecordingText::tr("the recording is damaged: %1").arg(what), {}, {m_path});
}

} // namespace teleta::recording
