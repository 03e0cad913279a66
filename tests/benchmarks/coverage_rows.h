// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::benchmarks {

/// A line of the coverage table: the random cases of one estimator and one disturbance, counted.
class CoverageRow {
public:
    CoverageRow(std::string estimator, std::string disturbance)
        : m_estimator(std::move(estimator))
        , m_disturbance(std::move(disturbance)) {}

    /// An answer. covered: its interval, or bound, holds the truth. width: of the interval, in the row's own
    /// unit; none for a bound.
    void add(bool covered, bool reliable, std::optional<double> width) {
        ++m_cases;
        m_covered += covered ? 1 : 0;
        m_flagged += reliable ? 0 : 1;
        m_honest += covered || !reliable ? 1 : 0;
        if (width)
            m_widths.push_back(*width);
    }
    /// No answer, which is honest.
    void addRefused() {
        ++m_cases;
        ++m_refused;
        ++m_honest;
    }

    [[nodiscard]] const std::string& estimator() const { return m_estimator; }
    [[nodiscard]] const std::string& disturbance() const { return m_disturbance; }
    [[nodiscard]] int cases() const { return m_cases; }
    [[nodiscard]] int covered() const { return m_covered; }
    [[nodiscard]] int flagged() const { return m_flagged; }
    [[nodiscard]] int refused() const { return m_refused; }
    /// Covered, flagged or refused.
    [[nodiscard]] int honest() const { return m_honest; }
    /// Empty without an interval.
    [[nodiscard]] std::optional<double> medianWidth() const {
        if (m_widths.empty())
            return std::nullopt;
        std::vector<double> widths = m_widths;
        const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
        std::ranges::nth_element(widths, middle);
        return *middle;
    }

private:
    std::string m_estimator;
    std::string m_disturbance;
    int m_cases = 0;
    int m_covered = 0;
    int m_flagged = 0;
    int m_refused = 0;
    int m_honest = 0;
    std::vector<double> m_widths;
};

using TakeRow = std::function<void(const CoverageRow&)>;

/// Each computes the rows of one estimator, with so many random cases a row, and hands them over one by one.
void stiffnessRows(int cases, const TakeRow& take);
void transferRows(int cases, const TakeRow& take);
void motorRows(int cases, const TakeRow& take);
void cameraRows(int cases, const TakeRow& take);
void shapeRows(int cases, const TakeRow& take);

} // namespace teleta::benchmarks
