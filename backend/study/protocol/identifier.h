// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/toml_table.h"

#include <set>
#include <string>
#include <string_view>

namespace teleta::study {

/// Reads a name that is safe in file names and in identifiers of every export: letters, digits, - and _, not
/// in `used`, to which it is added. Anything else is an error of the document.
[[nodiscard]] std::string readIdentifier(core::TomlTable& table, std::string_view key,
                                         std::set<std::string>& used);

} // namespace teleta::study
