// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace teleta::base {

/// A value with its standard error that does not flicker: each changes only when it has moved by a full step
/// of its text. The error has two significant digits, and the value as many decimals. Thread: one.
class SteadyEstimate {
public:
    /// A value that is not finite is undefined. Without an error above 0 the value stands as threeDigits().
    void update(double value, double error);
    /// "1.250 ± 0.050", the value filled up like threeDigits(); undefined: an em dash.
    [[nodiscard]] QString text() const;

private:
    std::optional<double> m_value;
    std::optional<double> m_error;
    int m_decimals = 0;
};

} // namespace teleta::base
