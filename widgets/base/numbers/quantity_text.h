// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace teleta::base {

/// Value with a number of decimals, for columns of numbers and running times: decimal sign of the user's
/// locale, no grouping, the minus is U+2212. Undefined or not finite: an em dash.
[[nodiscard]] QString fixedDigits(std::optional<double> value, int decimals);

/// Value with at most a number of significant digits, without trailing zeros, for the ticks of a scale;
/// otherwise as fixedDigits().
[[nodiscard]] QString significantDigits(std::optional<double> value, int digits);

/// Value with an SI prefix from pico to tera and three significant digits, or more, for use inside a
/// sentence: "12.3 mN".
[[nodiscard]] QString siText(std::optional<double> value, const QString& unit, int moreDigits = 0);

/// A length in metres as "12.3 mm", for use inside a sentence.
[[nodiscard]] QString millimetres(double length_m);

/// A number for a CSV file: C locale, the fewest digits that read back as the same double; NA when undefined
/// or not finite.
[[nodiscard]] QString csvNumber(std::optional<double> value);

/// A value as a number from 1 to 999 with an SI prefix from pico to tera (0 has none). Beyond these prefixes
/// the number is smaller or larger.
struct SiNumber {
    double mantissa = 0.0;
    char16_t prefix = 0;
};

/// value: finite.
[[nodiscard]] SiNumber siNumber(double value);

/// Decimals for three significant digits, at most two, after rounding: 9.996 is 10.0.
[[nodiscard]] int threeDigitDecimals(double value);

} // namespace teleta::base
