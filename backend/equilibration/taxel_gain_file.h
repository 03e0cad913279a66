// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/error.h"
#include "backend/equilibration/taxel_gains.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace teleta::equilibration {

inline constexpr std::array<std::string_view, 6> kTaxelGainColumns{"taxel", "row",     "column",
                                                                   "gain",  "gain_se", "state"};

/// Reads the gains of an array: CSV with the columns taxel,row,column,gain,gain_se,state, one row a taxel, in
/// any order; other columns are ignored. row and column count from 0, taxel = row * columns + column. gain:
/// factor on the load of the taxel, 1e-3 to 1e3; NA: the taxel is not used. gain_se and state ("good",
/// "dead", "weak", "strong", "stuck") may be missing or NA. Error: notFound, ioFailed, badInput with line and
/// column: the file is of another array, a taxel is repeated or missing, a gain is out of range, or a taxel
/// that is not good has one. Thread: any.
[[nodiscard]] core::Expected<TaxelGains> readTaxelGains(const std::string& path,
                                                        const core::ArrayLayout& layout);

/// Writes one row per taxel. Rows: a type with the members of core::CsvWriter.
template <typename Rows>
void writeTaxelGainRows(const TaxelGains& gains, Rows& rows) {
    for (std::size_t i = 0; i < gains.taxels.size(); ++i) {
        const auto columns = static_cast<std::size_t>(gains.layout.columns);
        const TaxelGain& taxel = gains.taxels[i];
        rows.integer(static_cast<long long>(i));
        rows.integer(static_cast<long long>(i / columns));
        rows.integer(static_cast<long long>(i % columns));
        rows.number(taxel.gain);
        rows.number(taxel.error);
        rows.text(toString(taxel.state));
        rows.endRow();
    }
}

/// Writes the file atomically; creates its folder. Error: ioFailed.
[[nodiscard]] core::Expected<void> writeTaxelGains(const TaxelGains& gains, const std::string& path);

} // namespace teleta::equilibration
