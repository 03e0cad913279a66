// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::base {

/// Smallest of 1, 2, 2.5, 5 times a power of ten that is at least value; > 0.
[[nodiscard]] double niceStep(double value);

/// Range of an axis or a colour map that follows its data calmly: it widens at once, to round numbers, and
/// narrows only after the data have stayed well inside it for a while. Thread: one.
class CalmRange {
public:
    /// minimumSpan: smallest difference of the ends, > 0, so that noise is not magnified.
    /// memory_s: time constant with which an extreme is forgotten.
    explicit CalmRange(double minimumSpan, double memory_s = 4.0);

    /// Takes the extremes of the newest data (low <= high, finite). The time may jump in both directions.
    /// Returns whether the shown range changed.
    bool update(double low, double high, double time_s);
    void reset();
    /// For data whose scale becomes known later; > 0.
    void setMinimumSpan(double span) { m_minimumSpan = span; }

    [[nodiscard]] double low() const { return m_shownLow; }
    [[nodiscard]] double high() const { return m_shownHigh; }

private:
    struct Ends {
        double low, high;
    };
    [[nodiscard]] Ends rounded() const;

    double m_minimumSpan;
    double m_memory_s;
    bool m_empty = true;
    double m_time_s = 0.0;
    double m_low = 0.0, m_high = 0.0; ///< extremes, slowly forgotten
    double m_shownLow = 0.0, m_shownHigh = 0.0;
};

} // namespace teleta::base
