// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace teleta::core {

/// A unit (UTF-8) as the end of the name of a column: lower case letters and digits, "u" for micro, "_per_"
/// for a stroke, nothing for other signs: "N" n, "\u00b5T" ut, "N/m" n_per_m. No unit is "counts". Thread:
/// any (pure).
[[nodiscard]] std::string columnUnit(std::string_view unit);

} // namespace teleta::core
