// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace teleta::base {

/// Width in characters to which threeDigits() and wholeNumber() pad, so that a changing number does not move
/// its unit: a sign and four more, enough for |value| < 10 000.
inline constexpr int kNumberWidth = 5;

/// Value in a fixed unit: three significant digits, at most two decimals ("0.05", "1.23", "12.3", "123",
/// "1234"). Right-aligned with figure spaces; the minus is U+2212; decimal sign of the user's locale.
/// Undefined: an em dash.
[[nodiscard]] QString threeDigits(std::optional<double> value);
/// Value rounded to an integer, filled up like threeDigits().
[[nodiscard]] QString wholeNumber(std::optional<double> value);

/// Value with three significant digits and an SI prefix from pico to tera: "12.3 mN". Of constant width.
[[nodiscard]] QString siQuantity(std::optional<double> value, const QString& unit);

/// number, a no-break space and the unit; without the space before a degree sign and when the unit is empty.
[[nodiscard]] QString withUnit(const QString& number, const QString& unit);

/// A count in at most four characters: "0", "999", "1.23 k", "45.6 M". Rounded down: it never overstates.
[[nodiscard]] QString shortCount(quint64 count);

/// A number that does not flicker: it changes only when the value has moved by a full step of its text.
/// Thread: one.
class SteadyNumber {
public:
    /// resolution: step of the text, > 0; 0 takes that of threeDigits().
    explicit SteadyNumber(double resolution = 0.0)
        : m_resolution(resolution) {}

    /// Returns whether the displayed value changed. An empty or non-finite value is undefined.
    bool update(std::optional<double> value);
    [[nodiscard]] std::optional<double> shown() const { return m_shown; }
    /// threeDigits() or, with a resolution of 1 or more, wholeNumber() of what is shown.
    [[nodiscard]] QString text() const;

private:
    double m_resolution;
    std::optional<double> m_shown;
};

} // namespace teleta::base
