// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

class QSqlDatabase;

namespace teleta::core {

/// Prepares an open SQLite database for a file that may come from somebody else, before anything is read from
/// it:
///   - SQLite's defensive mode; no views, no triggers, no functions with side effects in the schema;
///   - pages are checked for damage when they are read;
///   - a schema with anything but plain tables and indices is refused: the programs make no other.
/// A view in place of a table could otherwise keep the reader busy for ever.
/// Error: badInput. A database that cannot be read is left to the next statement. Thread: that of the
/// database.
[[nodiscard]] Expected<void> distrustSchema(QSqlDatabase& database, const std::string& path);

} // namespace teleta::core
