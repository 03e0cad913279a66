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

/// Where a study is kept: in study.sqlite of its folder, or on a PostgreSQL server, then with its exports in
/// the folder.
struct StoreLocation {
    StoreLocation(std::string studyFolder, std::string serverUrl = {}) // NOLINT: a folder is a location
        : folder(std::move(studyFolder))
        , server(std::move(serverUrl)) {}

    std::string folder;
    /// postgresql://[user[:password]@][host][:port][/database][?study=NAME&host=..&port=..&sslmode=..];
    /// empty: SQLite. What the URL lacks comes from the PG* environment and ~/.pgpass. study: the schema that
    /// the study is in, "study" unless given.
    std::string server;
};

/// The address of a server as it may stand in messages, logs and reports: without any password. Thread: any.
[[nodiscard]] std::string shownServer(const std::string& url);

/// A connection of Qt to the database of a study, SQLite or PostgreSQL, with what differs between them.
/// SQLite: write-ahead log while somebody may write, synchronous FULL; the last one who leaves takes the log
/// away, so that the file alone is the study and can be read where nothing can be written. PostgreSQL: a
/// connection that was lost is opened again at the next statement. Thread: the one that made it.
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

    /// Connects and brings the schema up to date. Error: notFound where there is no study and none is made;
    /// badInput, refused, ioFailed; unavailable when the server does not answer.
    [[nodiscard]] core::Expected<void> open(Purpose purpose);

    /// Executes one statement. Outside of transactions a lost connection is opened again, once, and the
    /// statement repeated: reconnections() tells. Error: refused for a constraint, badInput for a damaged
    /// file, unavailable when the server is away, ioFailed.
    [[nodiscard]] core::Expected<QSqlQuery> run(const QString& sql, const QVariantList& values = {});

    /// All that the function does, or nothing of it.
    [[nodiscard]] core::Expected<void> inTransaction(const std::function<core::Expected<void>()>& work);

    /// Only to be looked at: opened to be read.
    [[nodiscard]] bool isReadOnly() const { return m_isReadOnly; }
    [[nodiscard]] bool isServer() const { return !m_location.server.empty(); }
    [[nodiscard]] std::size_t reconnections() const { return m_reconnections; }
    [[nodiscard]] const StoreLocation& location() const { return m_location; }
    /// The file, or the server without any password.
    [[nodiscard]] const std::string& shownName() const { return m_shownName; }

    /// Server only: takes or gives back a lock of the session, which the server frees when the connection
    /// ends. Taken locks are taken again after a reconnection, from what the server may still have of the
    /// connection before, too; while that cannot be ended, every statement is unavailable, and while somebody
    /// else has one of them, refused. False: it is taken.
    [[nodiscard]] core::Expected<bool> lock(long long key);
    void unlock(long long key);
    /// Server only: the name of the machine that has the lock; empty when nobody has it.
    [[nodiscard]] core::Expected<std::string> lockedBy(long long key);

    [[nodiscard]] core::Unexpected damaged() const;
    [[nodiscard]] core::Unexpected refused(const QString& message, const QString& expected) const;

private:
    /// A connection as the server has it; a number alone may be another one's later.
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
    /// True: the server still has some of the connections that broke.
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
    std::vector<Backend> m_orphans;   ///< server only: those that broke and may still be there
    std::size_t m_reconnections = 0;
    bool m_inTransaction = false;
    bool m_isReadOnly = false;
};

} // namespace teleta::study
