// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::base {

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
