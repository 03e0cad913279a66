// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QSqlDatabase>
#include <QString>

namespace teleta::study {

/// The schema that this program writes.
[[nodiscard]] int currentSchema();

/// Brings a database, SQLite or PostgreSQL, from its schema (0: empty) to the current one in one transaction;
/// of several programs that do it at once, one does. Error: refused when it is newer, badInput when it is no
/// database, ioFailed. Thread: that of the connection.
[[nodiscard]] core::Expected<void> migrateSchema(QSqlDatabase& database, const std::string& file);

} // namespace teleta::study
