// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <numeric>
#include <ranges>
#include <span>
#include <vector>

/// Quantiles and medians. Types are those of Hyndman and Fan, Sample Quantiles in Statistical Packages
/// (1996). Functions without "sorted" in their parameters reorder the values that they are given. Thread: any
/// (pure).
namespace teleta::core {

/// Half width of a 95 % interval in standard errors, normal distribution.
inline constexpr double kNormalQuantile95 = 1.959963984540054;

/// Share of a normal distribution that lies below z standard deviations.
[[nodiscard]] inline double normalShare(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// Type 7, the default of R: linear between order statistics. sorted: not empty; probability: 0..1.
[[nodiscard]] inline double quantileOf(std::span<const double> sorted, double probability) {
    const double position = probability * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

/// The value of this rank, counted from 0 for the smallest. values: not empty, without NaN; reordered.
template <std::ranges::random_access_range Values>
[[nodiscard]] auto orderStatistic(Values&& values, std::size_t rank) {
    const auto place = std::ranges::begin(values) + static_cast<std::ptrdiff_t>(rank);
    std::ranges::nth_element(values, place);
    return *place;
}

/// Median; of an even number of values the mean of the middle two. values: as orderStatistic().
template <std::ranges::random_access_range Values>
[[nodiscard]] double medianOf(Values&& values) {
    const std::size_t half = std::ranges::size(values) / 2;
    const double upper = orderStatistic(values, half);
    if (std::ranges::size(values) % 2 == 1)
        return upper;
    const auto begin = std::ranges::begin(values);
    return std::midpoint(upper, *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(half)));
}

/// Median; of an even number of values the higher of the middle two, so that it is one of the values.
/// values: as orderStatistic().
template <std::ranges::random_access_range Values>
[[nodiscard]] auto upperMedianOf(Values&& values) {
    return orderStatistic(values, std::ranges::size(values) / 2);
}

/// Type 7 without interpolation: the order statistic below. values: as orderStatistic(); probability: 0..1.
template <std::ranges::random_access_range Values>
[[nodiscard]] auto lowerQuantileOf(Values&& values, double probability) {
    return orderStatistic(
        values, static_cast<std::size_t>(probability * static_cast<double>(std::ranges::size(values) - 1)));
}

} // namespace teleta::core
