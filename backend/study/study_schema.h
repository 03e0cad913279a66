// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QSqlDatabase>
#include <QString>

namespace teleta::study {

/// The schema that this program writes.
[[nodiscard]] int currentSchema();

/// Brings a database from its schema (PRAGMA user_version; 0: empty) to the current one, each step in a
/// transaction of its own. Error: refused when it is newer, ioFailed. Thread: that of the connection.
[[nodiscard]] core::Expected<void> migrateSchema(QSqlDatabase& database, const std::string& file);

} // namespace teleta::study
