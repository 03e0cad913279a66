// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"
#include "widgets/study/results/result_table.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace teleta::study {

// Cells of tables of results: shown in the language of the user, in files in the C locale. Thread: GUI.

/// A dash, and NA in files.
[[nodiscard]] ResultCell missing();
/// Missing also when not finite.
[[nodiscard]] ResultCell cell(const std::optional<double>& value, int decimals);
/// Both ends times factor; in files with a semicolon between them.
[[nodiscard]] ResultCell cell(const std::optional<Interval>& interval, int decimals, double factor = 1.0);
[[nodiscard]] ResultCell count(std::int64_t value);
/// "0.012", or "< 0.001".
[[nodiscard]] QString pText(double p);
/// "= 0.012", or "< 0.001".
[[nodiscard]] QString pRelation(double p);
[[nodiscard]] ResultCell pCell(const std::optional<double>& p);

} // namespace teleta::study
