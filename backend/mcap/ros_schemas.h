// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::mcap {

/// The text of a schema in the encoding "ros2msg" for a message with this definition: the definition, then
/// that of each type that it names, after a line of 80 "=" and a line "MSG: package/Type". Types are known to
/// rosDefinition(); one without a package is of the given one. Thread: any (pure).
[[nodiscard]] std::string schemaText(std::string_view definition, std::string_view package);

/// Appends the definition of one more type to the text of a schema. name: "package/Type".
void appendType(std::string& text, std::string_view name, std::string_view definition);

/// The definition of a type, as in its .msg file; empty for one that is not known. name: "package/Type", also
/// "package/msg/Type". Thread: any (pure).
[[nodiscard]] std::string_view rosDefinition(std::string_view name);

/// The fields of the message itself in the text of a schema, as pairs of type and name, without constants.
/// Thread: any (pure).
[[nodiscard]] std::vector<std::pair<std::string, std::string>> schemaFields(std::string_view text);

} // namespace teleta::mcap
