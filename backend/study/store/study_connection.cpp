// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/study_connection.h"

#include "backend/core/data/input_file.h"
#include "backend/core/failure.h"
#include "backend/core/sqlite/foreign_database.h"
#include "backend/study/store/study_schema.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSqlError>
#include <QStringList>
#include <QSysInfo>
#include <QUrl>
#include <QUrlQuery>
#include <QUuid>

#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace teleta::study {

namespace {

struct ConnectionText {
    Q_DECLARE_TR_FUNCTIONS(StudyStore)
};

constexpr int kWaitForOthers_ms = 10'000;
constexpr int kWaitForServer_s = 5;
/// Attempts to take a lock, 0.1 s apart, while the server ends the previous connection.
constexpr int kTriesForOrphans = 20;
constexpr QLatin1String kTryLock("SELECT pg_try_advisory_lock(hashtext(?), ?)");
constexpr QLatin1String kOwnBackend("SELECT pid, (extract(epoch FROM backend_start) * 1000000)::bigint "
                                    "FROM pg_stat_activity WHERE pid = pg_backend_pid()");
constexpr QLatin1String kEndBackend("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE pid = ? "
                                    "AND (extract(epoch FROM backend_start) * 1000000)::bigint = ?");

std::string fileIn(const std::string& folder) {
    return QDir(QString::fromStdString(folder)).filePath(QStringLiteral("study.sqlite")).toStdString();
}

bool canBeWritten(const std::string& folder) {
    return faccessat(AT_FDCWD, folder.c_str(), W_OK, AT_EACCESS) == 0;
}

bool hasLog(const QString& file) {
    return QFileInfo(file + QStringLiteral("-wal")).size() > 0;
}

/// A value quoted for libpq.
QString quotedForServer(QString value) {
    value.replace(QLatin1Char('\\'), QStringLiteral("\\\\"))
        .replace(QLatin1Char('\''), QStringLiteral("\\'"));
    return QLatin1Char('\'') + value + QLatin1Char('\'');
}

/// Options that are passed on to libpq.
const QStringList& passedOptions() {
    static const QStringList kOptions{QStringLiteral("sslmode"), QStringLiteral("sslrootcert"),
                                      QStringLiteral("sslcert"), QStringLiteral("sslkey")};
    return kOptions;
}

} // namespace

std::string shownServer(const std::string& url) {
    QUrl shown(QString::fromStdString(url));
    shown.setPassword({});
    QUrlQuery query(shown);
    query.removeAllQueryItems(QStringLiteral("password"));
    shown.setQuery(query);
    return shown.toString().toStdString();
}

StudyConnection::StudyConnection(StoreLocation location)
    : m_location(std::move(location))
    , m_shownName(isServer() ? shownServer(m_location.server) : fileIn(m_location.folder))
    , m_name(QUuid::createUuid().toString())
    , m_database(QSqlDatabase::addDatabase(isServer() ? QStringLiteral("QPSQL") : QStringLiteral("QSQLITE"),
                                           m_name)) {
}

StudyConnection::~StudyConnection() {
    // The server notices the end of a connection with a delay.
    for (const long long key : std::set<long long>(m_locks))
        unlock(key);
    leaveFile();
    m_database.close();
    m_database = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

core::Expected<void> StudyConnection::configureServer() {
    const QUrl url(QString::fromStdString(m_location.server), QUrl::StrictMode);
    const bool isPostgres =
        url.scheme() == QStringLiteral("postgresql") || url.scheme() == QStringLiteral("postgres");
    const auto badUrl = [&](const QString& message, const QString& expected) {
        return core::failed(core::ErrorKind::badInput, message, expected, {m_shownName});
    };
    if (!url.isValid() || !isPostgres)
        return badUrl(ConnectionText::tr("this is not the address of a PostgreSQL server"),
                      QStringLiteral("postgresql://user@host/database?study=name"));
    QStringList options{QStringLiteral("connect_timeout=%1").arg(kWaitForServer_s),
                        QStringLiteral("tcp_user_timeout=%1").arg(kWaitForOthers_ms),
                        QStringLiteral("application_name=") + quotedForServer(QSysInfo::machineHostName())};
    m_schema = QStringLiteral("study");
    m_database.setHostName(url.host(QUrl::FullyDecoded));
    m_database.setPort(url.port());
    const auto items = QUrlQuery(url).queryItems(QUrl::FullyDecoded);
    for (const auto& [key, value] : items) {
        if (key == QStringLiteral("study"))
            m_schema = value;
        else if (key == QStringLiteral("host"))
            m_database.setHostName(value);
        else if (key == QStringLiteral("port")) {
            bool isNumber = false;
            const int port = value.toInt(&isNumber);
            if (!isNumber || port < 1 || port > 65535)
                return badUrl(ConnectionText::tr("the address has the port \"%1\"").arg(value),
                              ConnectionText::tr("a whole number from 1 to 65535"));
            m_database.setPort(port);
        } else if (passedOptions().contains(key)) {
            // Qt separates options by semicolons.
            if (value.contains(QLatin1Char(';')))
                return badUrl(ConnectionText::tr("the option \"%1\" of the address has a semicolon").arg(key),
                              ConnectionText::tr("a value without semicolons"));
            options << key + QLatin1Char('=') + quotedForServer(value);
        } else
            return badUrl(ConnectionText::tr("the address has the unknown option \"%1\"").arg(key),
                          QStringLiteral("study, host, port, ") + passedOptions().join(QStringLiteral(", ")));
    }
    static const QRegularExpression kName(QStringLiteral("^[a-z_][a-z0-9_]{0,62}$"));
    if (!kName.match(m_schema).hasMatch())
        return badUrl(ConnectionText::tr("\"%1\" cannot name a study on a server").arg(m_schema),
                      ConnectionText::tr("lower-case letters, digits and _, no digit first"));
    m_database.setDatabaseName(url.path(QUrl::FullyDecoded).mid(1));
    m_database.setUserName(url.userName(QUrl::FullyDecoded));
    m_database.setPassword(url.password(QUrl::FullyDecoded));
    m_database.setConnectOptions(options.join(QLatin1Char(';')));
    return {};
}

core::Expected<void> StudyConnection::open(Purpose purpose) {
    if (isServer()) {
        if (!m_database.isValid())
            return core::failed(core::ErrorKind::notFound,
                                ConnectionText::tr("Qt's driver for PostgreSQL is not installed"),
                                ConnectionText::tr("the package %1").arg(QStringLiteral("libqt6sql6-psql")));
        TELETA_CHECK(configureServer());
    } else {
        TELETA_CHECK(configureFile(purpose));
    }
    if (m_isReadOnly)
        return connect().and_then([&] { return readFile(); });
    return connect().and_then([&] { return chooseSchema(purpose); }).and_then([&] {
        return migrateSchema(m_database, m_shownName,
                             [this](const QSqlError& error) { return kindOf(error); });
    });
}

core::Expected<void> StudyConnection::configureFile(Purpose purpose) {
    const QString file = QString::fromStdString(m_shownName);
    if (purpose != Purpose::create && !QFileInfo::exists(file))
        return core::failed(core::ErrorKind::notFound, ConnectionText::tr("there is no study here"),
                            ConnectionText::tr("a folder with study.sqlite"), {m_location.folder});
    if (QFileInfo::exists(file))
        TELETA_CHECK(core::requireFile(m_shownName));
    // SQLite would make it as the umask says, and gives its log the permissions of the file.
    if (purpose == Purpose::create && !QFileInfo::exists(file))
        (void)QFile(file).open(QIODevice::WriteOnly | QIODevice::NewOnly,
                               QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    QString options = QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(kWaitForOthers_ms);
    m_database.setDatabaseName(file);
    m_isReadOnly = purpose == Purpose::read;
    if (m_isReadOnly) {
        options += QStringLiteral(";QSQLITE_OPEN_READONLY");
        // Otherwise SQLite would need to create the (empty) log files; nobody can change the study here.
        if (!canBeWritten(m_location.folder) && !hasLog(file)) {
            m_database.setDatabaseName(QString::fromLatin1(QUrl::fromLocalFile(file).toEncoded()) +
                                       QStringLiteral("?immutable=1"));
            options += QStringLiteral(";QSQLITE_OPEN_URI");
        }
    }
    m_database.setConnectOptions(options);
    return {};
}

/// The schema of a read-only study.
core::Expected<void> StudyConnection::readFile() {
    QSqlQuery query(m_database);
    const bool isRead = query.exec(QStringLiteral("PRAGMA user_version")) && query.next();
    const bool canWrite = canBeWritten(m_location.folder);
    const int schema = isRead ? query.value(0).toInt() : 0;
    query.finish();
    // SQLite cannot always read a log that it cannot write.
    if (canWrite && (!isRead || (schema >= 0 && schema < currentSchema()))) {
        m_database.close();
        return open(Purpose::open);
    }
    if (!isRead && hasLog(QString::fromStdString(m_shownName)))
        return core::failed(
            core::ErrorKind::ioFailed,
            ConnectionText::tr("the program that ran this study was interrupted; its last trials "
                               "are in %1, which can be read only in a writable folder")
                .arg(QStringLiteral("study.sqlite-wal")),
            ConnectionText::tr("a copy of the whole folder in a writable place"), {m_shownName});
    if (!isRead)
        return failed(ConnectionText::tr("cannot read the study: %1"), query.lastError());
    if (schema >= 0 && schema < currentSchema())
        return core::failed(
            core::ErrorKind::refused,
            ConnectionText::tr("this study was made by an older program and cannot be upgraded here"),
            ConnectionText::tr("a copy of the whole folder in a writable place"), {m_shownName});
    return migrateSchema(m_database, m_shownName, [this](const QSqlError& error) { return kindOf(error); });
}

/// Without a log the file can be read everywhere. The log stays while somebody else has the file open.
void StudyConnection::leaveFile() {
    if (isServer() || m_isReadOnly || !m_database.isOpen())
        return;
    QSqlQuery query(m_database);
    (void)(query.exec(QStringLiteral("PRAGMA busy_timeout = 0")) &&
           query.exec(QStringLiteral("PRAGMA journal_mode = DELETE")));
}

core::Expected<void> StudyConnection::connect() {
    if (!m_database.open())
        return failed(ConnectionText::tr("cannot open the study: %1"), m_database.lastError());
    if (!isServer())
        TELETA_CHECK(core::distrustSchema(m_database, m_shownName));
    // Keep-alives, so that participants do not stay locked for hours after this station has lost power or
    // network. Older servers lack tcp_user_timeout.
    const auto settings =
        isServer()     ? QStringList{QStringLiteral("SET client_min_messages = error"),
                                 QStringLiteral("SET synchronous_commit = on"),
                                 QStringLiteral("SET statement_timeout = %1").arg(3 * kWaitForOthers_ms),
                                 QStringLiteral("SET tcp_keepalives_idle = 10"),
                                 QStringLiteral("SET tcp_keepalives_interval = 5"),
                                 QStringLiteral("SET tcp_keepalives_count = 3"),
                                 QStringLiteral("SELECT set_config(name, '25000', false) FROM pg_settings "
                                                        "WHERE name = 'tcp_user_timeout'")}
        : m_isReadOnly ? QStringList{}
                       : QStringList{QStringLiteral("PRAGMA journal_mode = WAL"),
                                     QStringLiteral("PRAGMA synchronous = FULL"),
                                     QStringLiteral("PRAGMA foreign_keys = ON")};
    for (const QString& setting : settings) {
        QSqlQuery query(m_database);
        if (!query.exec(setting))
            return failed(ConnectionText::tr("cannot open the study: %1"), query.lastError());
    }
    if (!isServer())
        return {};
    QSqlQuery query(m_database);
    if (!query.exec(kOwnBackend))
        return failed(ConnectionText::tr("cannot open the study: %1"), query.lastError());
    if (query.next())
        m_backend = Backend{query.value(0).toLongLong(), query.value(1).toLongLong()};
    return {};
}

core::Expected<void> StudyConnection::chooseSchema(Purpose purpose) {
    if (!isServer())
        return {};
    TELETA_TRY(auto found,
               execute(QStringLiteral("SELECT 1 FROM pg_namespace WHERE nspname = ?"), {m_schema}));
    if (!found.next()) {
        if (purpose != Purpose::create)
            return core::failed(core::ErrorKind::notFound,
                                ConnectionText::tr("the server has no study \"%1\"").arg(m_schema),
                                ConnectionText::tr("the name of a study on that server"), {m_shownName});
        const auto made = execute(QStringLiteral("CREATE SCHEMA IF NOT EXISTS %1").arg(m_schema), {});
        // Another station may create it at the same moment.
        if (!made && made.error().kind != core::ErrorKind::refused)
            return core::Unexpected(made.error());
    }
    TELETA_CHECK(execute(QStringLiteral("SET search_path = %1").arg(m_schema), {}));
    return {};
}

core::Expected<void> StudyConnection::reconnect() {
    m_database.close();
    if (m_backend)
        m_orphans.push_back(*m_backend);
    m_backend.reset();
    ++m_reconnections;
    core::Expected<void> back =
        connect().and_then([&] { return chooseSchema(Purpose::open); }).and_then([&] { return lockAgain(); });
    // Closed, so that the next statement selects the schema and takes the locks again.
    if (!back)
        m_database.close();
    return back;
}

/// After a network failure the server may keep the broken connection and its locks.
core::Expected<bool> StudyConnection::endOrphans() {
    std::vector<Backend> left;
    for (const Backend& orphan : m_orphans) {
        auto query = execute(kEndBackend, {orphan.pid, orphan.began_us});
        if (!query && query.error().kind == core::ErrorKind::unavailable)
            return core::Unexpected(query.error());
        // One that this user may not end may still exist.
        if (!query || query->next())
            left.push_back(orphan);
    }
    m_orphans = std::move(left);
    return !m_orphans.empty();
}

core::Expected<void> StudyConnection::lockAgain() {
    core::Expected<bool> orphaned = endOrphans();
    TELETA_CHECK(orphaned);
    int tries = 0;
    for (const long long key : m_locks) {
        while (true) {
            TELETA_TRY(auto query, execute(kTryLock, {m_schema, key}));
            query.next();
            if (query.value(0).toBool())
                break;
            if (!*orphaned)
                return refused(
                    ConnectionText::tr(
                        "another station took over this participant while the server was unreachable"),
                    ConnectionText::tr("one session of a participant at a time"));
            if (++tries > kTriesForOrphans)
                return core::failed(
                    core::ErrorKind::unavailable,
                    ConnectionText::tr(
                        "the server still holds the broken connection, and with it this participant"),
                    ConnectionText::tr("another try in a moment"), {m_shownName});
            TELETA_CHECK(execute(QStringLiteral("SELECT pg_sleep(0.1)"), {}));
            orphaned = endOrphans();
            TELETA_CHECK(orphaned);
        }
    }
    return {};
}

core::Expected<QSqlQuery> StudyConnection::run(const QString& sql, const QVariantList& values) {
    core::Expected<QSqlQuery> done = execute(sql, values);
    if (done || m_inTransaction || done.error().kind != core::ErrorKind::unavailable)
        return done;
    TELETA_CHECK(reconnect());
    return execute(sql, values);
}

core::Expected<QSqlQuery> StudyConnection::execute(const QString& sql, const QVariantList& values) {
    if (!m_database.isOpen())
        return failed(ConnectionText::tr("cannot use the study: %1"), m_database.lastError());
    QSqlQuery query(m_database);
    query.setForwardOnly(!isServer()); // PostgreSQL would have nothing else run before all rows are read
    // PostgreSQL prepares no statements like SET and CREATE.
    bool done = values.isEmpty() || query.prepare(sql);
    for (const QVariant& value : values)
        query.addBindValue(value);
    done = done && (values.isEmpty() ? query.exec(sql) : query.exec());
    if (done)
        return query;
    const core::Unexpected error = failed(ConnectionText::tr("cannot use the study: %1"), query.lastError());
    if (m_inTransaction)
        m_failed.push_back(std::move(query));
    return error;
}

core::Expected<void> StudyConnection::inTransaction(const std::function<core::Expected<void>()>& work) {
    TELETA_CHECK(run(QStringLiteral("BEGIN")));
    m_inTransaction = true;
    const core::Expected<void> done =
        work().and_then([&] { return execute(QStringLiteral("COMMIT"), {}); }).map([](const QSqlQuery&) {});
    if (!done)
        (void)execute(QStringLiteral("ROLLBACK"), {});
    m_inTransaction = false;
    m_failed.clear();
    return done;
}

core::Expected<bool> StudyConnection::lock(long long key) {
    if (m_locks.contains(key))
        return false;
    TELETA_TRY(auto query, run(kTryLock, {m_schema, key}));
    query.next();
    const bool taken = query.value(0).toBool();
    if (taken)
        m_locks.insert(key);
    return taken;
}

void StudyConnection::unlock(long long key) {
    // Without a connection there are no locks.
    if (m_locks.erase(key) > 0)
        (void)execute(QStringLiteral("SELECT pg_advisory_unlock(hashtext(?), ?)"), {m_schema, key});
}

core::Expected<std::string> StudyConnection::lockedBy(long long key) {
    if (m_locks.contains(key))
        return QSysInfo::machineHostName().toStdString();
    TELETA_TRY(auto query,
               run(QStringLiteral(
                       "SELECT application_name FROM pg_locks JOIN pg_stat_activity USING (pid) "
                       "WHERE locktype = 'advisory' AND classid::bigint = hashtext(?)::bigint & 4294967295 "
                       "AND objid::bigint = ? AND objsubid = 2 AND granted AND pid <> pg_backend_pid() "
                       "AND datname = current_database()"),
                   {m_schema, key}));
    if (!query.next())
        return std::string();
    const std::string name = query.value(0).toString().toStdString();
    return name.empty() ? ConnectionText::tr("another station").toStdString() : name;
}

core::ErrorKind StudyConnection::kindOf(const QSqlError& error) const {
    if (isServer()) {
        // SQLSTATE codes; none when the connection broke or never existed.
        const QString code = error.nativeErrorCode();
        if (code.startsWith(QStringLiteral("23")) || code == QStringLiteral("42P06"))
            return core::ErrorKind::refused;
        const bool isAway = code.isEmpty() || code.startsWith(QStringLiteral("08")) ||
                            code.startsWith(QStringLiteral("57P")) || code == QStringLiteral("53300");
        return isAway ? core::ErrorKind::unavailable : core::ErrorKind::ioFailed;
    }
    // The low byte of SQLite's extended codes is the primary code.
    constexpr int kCorrupt = 11;
    constexpr int kConstraint = 19;
    constexpr int kNotADatabase = 26;
    const int code = error.nativeErrorCode().toInt() & 0xFF;
    if (code == kConstraint)
        return core::ErrorKind::refused;
    return code == kNotADatabase || code == kCorrupt ? core::ErrorKind::badInput : core::ErrorKind::ioFailed;
}

core::Unexpected StudyConnection::failed(const QString& what, const QSqlError& error) const {
    QString reason = error.databaseText().isEmpty() ? error.driverText() : error.databaseText().simplified();
    constexpr int kReadOnly = 8;
    if (!isServer() && (error.nativeErrorCode().toInt() & 0xFF) == kReadOnly)
        reason = ConnectionText::tr("it is read-only here");
    return core::failed(kindOf(error), what.arg(reason), {}, {m_shownName});
}

core::Unexpected StudyConnection::damaged() const {
    return core::failed(
        core::ErrorKind::badInput,
        ConnectionText::tr("the study is damaged: a session or trial has a number outside its protocol"), {},
        {m_shownName});
}

core::Unexpected StudyConnection::refused(const QString& message, const QString& expected) const {
    return core::failed(core::ErrorKind::refused, message, expected, {m_shownName});
}

} // namespace teleta::study
