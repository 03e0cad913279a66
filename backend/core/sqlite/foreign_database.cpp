// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/sqlite/foreign_database.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlDriver>
#include <QSqlQuery>
#include <QVariant>

#include <cstring>
#include <sqlite3.h>

namespace teleta::core {

namespace {

struct DatabaseText {
    Q_DECLARE_TR_FUNCTIONS(ForeignDatabase)
};

/// Null: the driver is another one, or has an SQLite of its own.
sqlite3* handleOf(const QSqlDatabase& database) {
    const QVariant handle = database.driver()->handle();
    if (!handle.isValid() || std::strcmp(handle.typeName(), "sqlite3*") != 0)
        return nullptr;
    return *static_cast<sqlite3* const*>(handle.constData());
}

} // namespace

Expected<void> distrustSchema(QSqlDatabase& database, const std::string& path) {
    sqlite3* handle = handleOf(database);
    const auto configure = [handle](int option, int value) {
        return sqlite3_db_config(handle, option, value, nullptr) == SQLITE_OK;
    };
    const bool done = handle != nullptr && configure(SQLITE_DBCONFIG_DEFENSIVE, 1) &&
                      configure(SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0) &&
                      configure(SQLITE_DBCONFIG_ENABLE_VIEW, 0) &&
                      configure(SQLITE_DBCONFIG_ENABLE_TRIGGER, 0);
    if (!done)
        return failed(ErrorKind::unavailable, DatabaseText::tr("SQLite cannot be made defensive"),
                      DatabaseText::tr("SQLite %1 or newer").arg(QStringLiteral("3.31")), {path});
    QSqlQuery query(database);
    (void)query.exec(QStringLiteral("PRAGMA cell_size_check = ON"));
    if (query.exec(
            QStringLiteral("SELECT type, name FROM sqlite_master WHERE type NOT IN ('table', 'index') OR "
                           "(type = 'table' AND (rootpage IS NULL OR rootpage <= 0)) LIMIT 1")) &&
        query.next())
        return failed(ErrorKind::badInput,
                      DatabaseText::tr("the file holds a %1, \"%2\", which this program does not make",
                                       "view, trigger or (virtual) table of a database")
                          .arg(query.value(0).toString().left(20), query.value(1).toString().left(60)),
                      DatabaseText::tr("plain tables and indices only"), {path});
    return {};
}

} // namespace teleta::core
