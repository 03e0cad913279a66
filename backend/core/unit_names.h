// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace teleta::core {

// One table says which unit stands at the end of a name. The keys of TOML files have the letter case of the
// unit
// ("stiffness_N_per_m"); whatever leaves the program, columns and keys of JSON, is all lower case
// ("stiffness_n_per_m"). There "_nm" is the newton metre: lengths are "_m" or "_mm".

/// Unit of a key in a TOML file, in either letter case: "N/m" of "stiffness_N_per_m"; empty: none. The
/// longest ending of the table counts. Thread: any (pure).
[[nodiscard]] std::string_view unitOf(std::string_view key);

/// The same without the unit: "stiffness". Thread: any (pure).
[[nodiscard]] std::string_view withoutUnit(std::string_view key);

/// The key with its unit in lower case: "rate_hz" of "rate_Hz". Thread: any (pure).
[[nodiscard]] std::string lowerCaseUnit(std::string_view key);

/// Unit of a column of a file that the program writes: "N m" of "joint_torque_nm", empty for what has none
/// ("contact_id", "qw"). Nothing: the table does not know the column, or its unit is in upper case.
/// Thread: any (pure).
[[nodiscard]] std::optional<std::string_view> unitOfColumn(std::string_view column);

} // namespace teleta::core
