// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QVariant>

#include <functional>
#include <string>

class QIODevice;

namespace teleta::recording {

/// The SQLite file of a recording: pragma application_id says that it is one, user_version which schema it
/// has.
/// Thread: the one that made it.
class RecordingDatabase {
public:
    explicit RecordingDatabase(std::string path);
    ~RecordingDatabase();
    RecordingDatabase(const RecordingDatabase&) = delete;
    RecordingDatabase& operator=(const RecordingDatabase&) = delete;

    /// Creates the file with the current schema and a write-ahead log. Error: refused when the file exists;
    /// ioFailed, and no file is left then.
    [[nodiscard]] core::Expected<void> create();

    /// Opens a file for reading, also one whose writer was killed: its write-ahead log is merged if the file
    /// is writable and nobody else has it open. An older schema is upgraded if the file is writable. Error:
    /// notFound; badInput: not a recording, damaged, or of a newer version; ioFailed.
    [[nodiscard]] core::Expected<void> openForReading();

    /// Opens a finished file to change it. Error: as openForReading().
    [[nodiscard]] core::Expected<void> openForWriting();

    /// Completes the file by merging its write-ahead log. While somebody else reads the file the log cannot
    /// be merged; after a second it is left, and merged when the file is next opened for writing.
    [[nodiscard]] core::Expected<void> finish();

    [[nodiscard]] core::Expected<QSqlQuery> run(const QString& sql, const QVariantList& values = {});
    /// Carries out the work in a transaction, which is rolled back if the work fails.
    [[nodiscard]] core::Expected<void> inTransaction(const std::function<core::Expected<void>()>& work);
    /// A statement to be executed many times.
    [[nodiscard]] core::Expected<QSqlQuery> prepare(const QString& sql);
    [[nodiscard]] core::Expected<void> execute(QSqlQuery& query);

    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] core::Unexpected failed(const QSqlError& error) const;
    [[nodiscard]] core::Unexpected damaged(const QString& what) const;

    /// Whether an object of this process writes the file that it made. Thread: any.
    [[nodiscard]] static bool isWrittenHere(const std::string& path);

    /// Whether the bytes that come next are the first ones of an SQLite file.
    [[nodiscard]] static bool beginsLikeOne(QIODevice& file);

    /// The schema that this version of the program writes.
    [[nodiscard]] static int currentSchema();

private:
    [[nodiscard]] core::Expected<void> connect(const QString& options);
    [[nodiscard]] core::Expected<void> checkFile() const;
    [[nodiscard]] core::Expected<void> checkKind(int& schema);
    [[nodiscard]] core::Expected<void> migrate(int from);
    void foldLog();
    void close();

    std::string m_path;
    QString m_name;
    QString m_written; ///< as WrittenFiles has it; empty: it did not make the file
    QSqlDatabase m_database;
};

} // namespace teleta::recording
