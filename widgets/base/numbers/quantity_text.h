// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace teleta::base {

/// Value with so many decimals, for columns of numbers and for times that go on: decimal sign of the user's
/// locale, no groups, the minus is U+2212. Undefined or not finite: an em dash.
[[nodiscard]] QString fixedDigits(std::optional<double> value, int decimals);

/// Value with at most so many significant digits and no zeros after them, for the marks of a scale; the rest
/// as fixedDigits().
[[nodiscard]] QString significantDigits(std::optional<double> value, int digits);

/// Value with an SI prefix from pico to tera, with three significant digits and so many more, for use inside
/// a sentence: "12.3 mN".
[[nodiscard]] QString siText(std::optional<double> value, const QString& unit, int moreDigits = 0);

/// A length of so many metres as "12.3 mm", for use inside a sentence.
[[nodiscard]] QString millimetres(double length_m);

/// A number of a CSV file: C locale, the fewest digits that read back as the same double, NA when it is
/// undefined or not finite.
[[nodiscard]] QString csvNumber(std::optional<double> value);

} // namespace teleta::base
