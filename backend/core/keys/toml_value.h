// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

namespace teleta::core {

/// A single value of a TOML file. A whole number is a long long.
using TomlValue = std::variant<bool, long long, double, std::string>;

/// As a file of results shows it: "true", a number with the fewest digits that read back as the same double,
/// the text without quotation marks. Thread: any (pure).
[[nodiscard]] std::string plainText(const TomlValue& value);

} // namespace teleta::core
