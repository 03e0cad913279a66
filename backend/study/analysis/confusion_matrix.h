// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace teleta::study {

/// How often each pattern was answered when each was presented. Rows: presented; columns: answered, plus a
/// last one for trials without an answer in time (NONE). Thread: one.
class ConfusionMatrix {
public:
    /// patterns: at least 1.
    explicit ConfusionMatrix(std::size_t patterns);

    [[nodiscard]] std::size_t patterns() const { return m_patterns; }
    [[nodiscard]] std::size_t columns() const { return m_patterns + 1; }
    [[nodiscard]] std::size_t noneColumn() const { return m_patterns; }

    /// stimulus, response: 0 .. patterns-1; no response: NONE. count: not negative.
    void add(std::size_t stimulus, std::optional<std::size_t> response, std::int64_t count = 1);

    /// Adds all trials of another matrix of the same size.
    void add(const ConfusionMatrix& other);

    [[nodiscard]] std::int64_t count(std::size_t row, std::size_t column) const {
        return m_counts[row * columns() + column];
    }
    [[nodiscard]] std::int64_t rowTotal(std::size_t row) const;
    [[nodiscard]] std::int64_t columnTotal(std::size_t column) const;
    [[nodiscard]] std::int64_t total() const;
    [[nodiscard]] std::int64_t correct() const;
    [[nodiscard]] std::int64_t unanswered() const { return columnTotal(noneColumn()); }

    /// Share of the row in percent; empty for a pattern that was never presented.
    [[nodiscard]] std::optional<double> rowPercent(std::size_t row, std::size_t column) const;

    /// Share of correct trials; empty without trials.
    [[nodiscard]] std::optional<double> accuracy() const;

    friend bool operator==(const ConfusionMatrix&, const ConfusionMatrix&) = default;

private:
    std::size_t m_patterns;
    std::vector<std::int64_t> m_counts; ///< row after row
};

} // namespace teleta::study
