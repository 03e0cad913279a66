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
/// what the taxel's load is multiplied with, from 1e-3 to 1e3; NA: the taxel is not used. gain_se may be
/// missing or NA, and so may state ("good", "dead", "weak", "strong", "stuck").
/// Error: notFound, ioFailed, badInput with line and column: another array, a taxel twice or not at all, a
/// gain out of range, or one whose state is not good. Thread: any.
[[nodiscard]] core::Expected<TaxelGains> readTaxelGains(const std::string& path,
                                                        const core::ArrayLayout& layout);

/// Writes the rows to something with the members of core::CsvWriter.
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

/// The file is whole or as it was; its folder is made.
[[nodiscard]] core::Expected<void> writeTaxelGains(const TaxelGains& gains, const std::string& path);

} // namespace teleta::equilibration
