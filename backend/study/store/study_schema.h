// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QSqlDatabase>
#include <QSqlError>
#include <QString>

#include <functional>
#include <string>

namespace teleta::study {

/// Schema version of this program.
[[nodiscard]] int currentSchema();

/// Upgrades a database, SQLite or PostgreSQL, from its schema (0: empty) to the current one in one
/// transaction; if several programs try at once, one does it. name: for errors. Error: refused when it is
/// newer, badInput when another program made it, otherwise as kindOf says. Thread: that of the connection.
[[nodiscard]] core::Expected<void>
migrateSchema(QSqlDatabase& database, const std::string& name,
              const std::function<core::ErrorKind(const QSqlError&)>& kindOf);

} // namespace teleta::study
