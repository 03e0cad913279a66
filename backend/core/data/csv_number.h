// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace teleta::core {

/// A field of CsvReader::nextText() as CsvWriter writes numbers: NaN for NA, a finite number, or nothing for
/// anything else. Thread: any (pure).
[[nodiscard]] inline std::optional<double> numberOrNA(std::string_view field) {
    if (field == "NA")
        return std::numeric_limits<double>::quiet_NaN();
    double value = 0.0;
    const char* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace teleta::core
