// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QSqlDatabase>
#include <QSqlError>
#include <QString>

#include <functional>
#include <string>

namespace teleta::study {

/// The schema that this program writes.
[[nodiscard]] int currentSchema();

/// Brings a database, SQLite or PostgreSQL, from its schema (0: empty) to the current one in one transaction;
/// of several programs that do it at once, one does. name: for errors. Error: refused when it is newer,
/// badInput when another program made it, else what kindOf says. Thread: that of the connection.
[[nodiscard]] core::Expected<void>
migrateSchema(QSqlDatabase& database, const std::string& name,
              const std::function<core::ErrorKind(const QSqlError&)>& kindOf);

} // namespace teleta::study
