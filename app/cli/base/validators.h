// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace teleta::cli {

/// Checks for option values; NaN and infinities are refused by all of them.
[[nodiscard]] CLI::Validator finite();
[[nodiscard]] CLI::Validator nonZero();
[[nodiscard]] CLI::Validator positive();
/// lower <= value <= upper.
[[nodiscard]] CLI::Validator between(double lower, double upper);
/// A whole number of 64 bits without a sign, in decimal digits.
[[nodiscard]] CLI::Validator seed();

} // namespace teleta::cli
