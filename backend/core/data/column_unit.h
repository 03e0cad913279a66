// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace teleta::core {

/// A unit (UTF-8) as the end of the name of a column: lower case letters and digits, "u" for micro, "_per_"
/// for a stroke, nothing for other signs: "N" n, "\u00b5T" ut, "N/m" n_per_m. No unit is "counts". Thread:
/// any (pure).
[[nodiscard]] std::string columnUnit(std::string_view unit);

/// The same for the moment of loads in this unit: "N" nm, otherwise the unit times metres, "\u00b5T" ut_m.
/// Thread: any (pure).
[[nodiscard]] std::string momentColumnUnit(std::string_view loadUnit);

} // namespace teleta::core
