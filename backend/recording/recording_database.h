// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QVariant>

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

    /// Makes the file with the present schema and a write-ahead log. Error: refused when there is such a file
    /// already; ioFailed, and then there is no file.
    [[nodiscard]] core::Expected<void> create();

    /// Opens a file for reading, also one whose writer was killed: its write-ahead log goes into it when the
    /// file can be written and nobody else has it open. An older schema is brought up to date when the file
    /// can be written. Error: notFound; badInput: no recording, damaged, or of a newer version; ioFailed.
    [[nodiscard]] core::Expected<void> openForReading();

    /// Opens a file that is complete, to change it. Error: as openForReading().
    [[nodiscard]] core::Expected<void> openForWriting();

    /// Makes the file complete by itself: without a write-ahead log. While somebody else reads it the log
    /// cannot be folded in; after a second it is left, and goes into the file when it is opened for writing
    /// again.
    [[nodiscard]] core::Expected<void> finish();

    [[nodiscard]] core::Expected<QSqlQuery> run(const QString& sql, const QVariantList& values = {});
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
