// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace teleta::cli {

/// A message for people: a field a line, parts of a field indented below it, lists of numbers and texts in
/// one line. Numbers have the fewest digits that read back as the same; control characters of texts are
/// written as \xNN, so that a message cannot steer the terminal. Ends with a line "---".
[[nodiscard]] std::string echoText(const nlohmann::ordered_json& message);

} // namespace teleta::cli
