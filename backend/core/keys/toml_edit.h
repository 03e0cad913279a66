// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/toml_value.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace teleta::core {

/// A TOML document with other values under some keys. A path names tables with dots between them; an entry of
/// a list of tables is named by its number from 0 or by its "name": "object.0.radius_m",
/// "object.sponge.radius_m". A table that is missing is made. A missing entry of a list is made when the path
/// names it by its name. Comments are lost. file: named in errors. Error: badInput for text that is not TOML,
/// a path through a value that is no table, and an entry that is not there. Thread: any (pure).
[[nodiscard]] Expected<std::string> withTomlValues(std::string_view text, const std::string& file,
                                                   std::span<const std::pair<std::string, TomlValue>> values);

} // namespace teleta::core
