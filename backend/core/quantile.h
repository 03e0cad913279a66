// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace teleta::core {

/// Sample quantile, linear between order statistics (type 7 of Hyndman and Fan, the default of R).
/// sorted: not empty; probability: 0..1. Thread: any (pure).
[[nodiscard]] inline double quantileOf(std::span<const double> sorted, double probability) {
    const double position = probability * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

} // namespace teleta::core
