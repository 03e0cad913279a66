// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace teleta::core {

[[nodiscard]] inline bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

[[nodiscard]] inline bool isNotNegative(double value) {
    return std::isfinite(value) && value >= 0.0;
}

[[nodiscard]] inline bool arePositive(std::initializer_list<double> values) {
    return std::ranges::all_of(values, isPositive);
}

[[nodiscard]] inline bool areNotNegative(std::initializer_list<double> values) {
    return std::ranges::all_of(values, isNotNegative);
}

[[nodiscard]] inline bool areFinite(std::initializer_list<double> values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

} // namespace teleta::core
