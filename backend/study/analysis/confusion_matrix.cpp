// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/confusion_matrix.h"

#include <algorithm>
#include <numeric>

namespace teleta::study {

ConfusionMatrix::ConfusionMatrix(std::size_t patterns)
    : m_patterns(patterns)
    , m_counts(patterns * (patterns + 1), 0) {
}

void ConfusionMatrix::add(std::size_t stimulus, std::optional<std::size_t> response, std::int64_t count) {
    m_counts.at(stimulus * columns() + response.value_or(noneColumn())) += count;
}

void ConfusionMatrix::add(const ConfusionMatrix& other) {
    std::transform(m_counts.begin(), m_counts.end(), other.m_counts.begin(), m_counts.begin(), std::plus<>());
}

std::int64_t ConfusionMatrix::rowTotal(std::size_t row) const {
    const auto first = m_counts.begin() + static_cast<std::ptrdiff_t>(row * columns());
    return std::accumulate(first, first + static_cast<std::ptrdiff_t>(columns()), std::int64_t{0});
}

std::int64_t ConfusionMatrix::columnTotal(std::size_t column) const {
    std::int64_t sum = 0;
    for (std::size_t row = 0; row < m_patterns; ++row)
        sum += count(row, column);
    return sum;
}

std::int64_t ConfusionMatrix::total() const {
    return std::accumulate(m_counts.begin(), m_counts.end(), std::int64_t{0});
}

std::int64_t ConfusionMatrix::correct() const {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < m_patterns; ++i)
        sum += count(i, i);
    return sum;
}

std::optional<double> ConfusionMatrix::rowPercent(std::size_t row, std::size_t column) const {
    const std::int64_t total = rowTotal(row);
    if (total == 0)
        return std::nullopt;
    return 100.0 * static_cast<double>(count(row, column)) / static_cast<double>(total);
}

std::optional<double> ConfusionMatrix::accuracy() const {
    const std::int64_t n = total();
    if (n == 0)
        return std::nullopt;
    return static_cast<double>(correct()) / static_cast<double>(n);
}

} // namespace teleta::study
