// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QVariant>

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

class QSqlError;

namespace teleta::study {

/// Where a study is stored: in study.sqlite in its folder, or on a PostgreSQL server with its exports in the
/// folder.
struct StoreLocation {
    StoreLocation(std::string studyFolder, std::string serverUrl = {}) // NOLINT: a folder is a location
        : folder(std::move(studyFolder))
        , server(std::move(serverUrl)) {}

    std::string folder;
    /// postgresql://[user[:password]@][host][:port][/database][?study=NAME&host=..&port=..&sslmode=..];
    /// empty: SQLite. Missing parts come from the PG* environment and ~/.pgpass. study: the schema of the
    /// study, "study" unless given.
    std::string server;
};

/// The address of a server for messages, logs and reports: without any password. Thread: any.
[[nodiscard]] std::string shownServer(const std::string& url);

/// A connection to the database of a study; hides what differs between SQLite and PostgreSQL. SQLite:
/// write-ahead log while somebody may write, synchronous FULL; the last connection to close removes the log,
/// so that the file alone is the study and can be read on read-only media. PostgreSQL: a lost connection is
/// reopened at the next statement. Thread: the one that made it.
class StudyConnection {
public:
    enum class Purpose {
        create,
        open,
        read, ///< nothing is written, but an older schema is brought up to date where that is possible
    };

    explicit StudyConnection(StoreLocation location);
    ~StudyConnection();
    StudyConnection(const StudyConnection&) = delete;
    StudyConnection& operator=(const StudyConnection&) = delete;

    /// Connects and upgrades the schema. Error: notFound where there is no study and none is created;
    /// badInput, refused, ioFailed; unavailable when the server does not answer.
    [[nodiscard]] core::Expected<void> open(Purpose purpose);

    /// Executes one statement. Outside of transactions a lost connection is reopened once and the statement
    /// repeated: reconnections() counts that. Error: refused for a constraint, badInput for a damaged file,
    /// unavailable when the server is away, ioFailed.
    [[nodiscard]] core::Expected<QSqlQuery> run(const QString& sql, const QVariantList& values = {});

    /// Runs the function in a transaction, which is rolled back if it fails.
    [[nodiscard]] core::Expected<void> inTransaction(const std::function<core::Expected<void>()>& work);

    /// Opened for reading.
    [[nodiscard]] bool isReadOnly() const { return m_isReadOnly; }
    [[nodiscard]] bool isServer() const { return !m_location.server.empty(); }
    [[nodiscard]] std::size_t reconnections() const { return m_reconnections; }
    [[nodiscard]] const StoreLocation& location() const { return m_location; }
    /// The file, or the server without any password.
    [[nodiscard]] const std::string& shownName() const { return m_shownName; }

    /// Server only: takes or releases an advisory lock of the database session, which the server releases
    /// when the connection ends. After a reconnection held locks are taken again, even from the remains of
    /// the broken connection on the server; while these cannot be ended, every statement fails as
    /// unavailable, and while somebody else has one of the locks, as refused. False: somebody else has it.
    [[nodiscard]] core::Expected<bool> lock(long long key);
    void unlock(long long key);
    /// Server only: name of the machine that holds the lock; empty: nobody.
    [[nodiscard]] core::Expected<std::string> lockedBy(long long key);

    [[nodiscard]] core::Unexpected damaged() const;
    [[nodiscard]] core::Unexpected refused(const QString& message, const QString& expected) const;

private:
    /// A connection on the server; a pid alone may be reused.
    struct Backend {
        long long pid = 0;
        long long began_us = 0; ///< since 1970 on the server's clock
    };

    [[nodiscard]] core::Expected<void> configureServer();
    [[nodiscard]] core::Expected<void> configureFile(Purpose purpose);
    [[nodiscard]] core::Expected<void> connect();
    [[nodiscard]] core::Expected<void> readFile();
    void leaveFile();
    [[nodiscard]] core::Expected<void> chooseSchema(Purpose purpose);
    [[nodiscard]] core::Expected<void> reconnect();
    /// True: the server still has some of the broken connections.
    [[nodiscard]] core::Expected<bool> endOrphans();
    [[nodiscard]] core::Expected<void> lockAgain();
    [[nodiscard]] core::Expected<QSqlQuery> execute(const QString& sql, const QVariantList& values);
    [[nodiscard]] core::Unexpected failed(const QString& what, const QSqlError& error) const;
    [[nodiscard]] core::ErrorKind kindOf(const QSqlError& error) const;

    StoreLocation m_location;
    std::string m_shownName;
    QString m_schema; ///< server only
    QString m_name;
    QSqlDatabase m_database;
    std::set<long long> m_locks;
    std::optional<Backend> m_backend; ///< server only
    std::vector<Backend> m_orphans;   ///< server only: broken ones that may still exist
    /// Statements of the transaction that failed. A server would not free them before its end, about which Qt
    /// writes to standard error.
    std::vector<QSqlQuery> m_failed;
    std::size_t m_reconnections = 0;
    bool m_inTransaction = false;
    bool m_isReadOnly = false;
};

} // namespace teleta::study
