// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace teleta::charts {

/// Why a sample is not joined to the previous one.
enum class Break : std::uint8_t {
    none,
    missing, ///< samples between them were lost
    jump,    ///< the stream jumped: seek, loop, reconnect
};

/// When a sample was taken.
struct SampleTime {
    std::int64_t time_ns = 0;
    double sourceTime_s = 0.0;
    bool discontinuity = false;
};

/// The newest samples of one stream, each a row of values; the oldest are overwritten.
///
/// Chart time always increases, even where the stream's own time jumps, so that later samples are always
/// further right: a gap takes its own length, a jump the time that passed for the viewer, 0.25 to 2 s. Two
/// samples have a gap between them when they are more than five sample periods and 0.1 s apart. append() does
/// not allocate. Thread: one.
class SampleHistory {
public:
    /// columns: values per sample. capacity > 0: 65536 samples are 60 s at 1 kHz or 5 min at 200 Hz.
    explicit SampleHistory(std::size_t columns, std::size_t capacity = 65536);

    /// values: one for each column, NaN where undefined.
    void append(const SampleTime& time, std::span<const double> values);
    void clear();

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }
    /// Number of samples ever appended, to detect new ones.
    [[nodiscard]] std::uint64_t appended() const { return m_appended; }

    /// Samples are numbered from 0, the oldest stored one.
    [[nodiscard]] double time_s(std::size_t index) const { return m_time_s[slot(index)]; }
    [[nodiscard]] double sourceTime_s(std::size_t index) const { return m_sourceTime_s[slot(index)]; }
    /// Arrival time on the steady clock.
    [[nodiscard]] std::int64_t time_ns(std::size_t index) const { return m_time_ns[slot(index)]; }
    [[nodiscard]] double value(std::size_t column, std::size_t index) const {
        return m_values[column][slot(index)];
    }
    [[nodiscard]] Break breakBefore(std::size_t index) const { return m_breaks[slot(index)]; }

    /// 0 while it is empty.
    [[nodiscard]] double newestTime_s() const { return m_size == 0 ? 0.0 : time_s(m_size - 1); }
    [[nodiscard]] double oldestTime_s() const { return m_size == 0 ? 0.0 : time_s(0); }
    /// First sample at or after a chart time; size() when there is none.
    [[nodiscard]] std::size_t firstAt(double time_s) const;
    /// The sample nearest to a chart time, unless it is further away than the length of a gap.
    [[nodiscard]] std::optional<std::size_t> nearest(double time_s) const;
    /// The newest sample whose source time is nearest to this one.
    [[nodiscard]] std::optional<std::size_t> nearestSource(double sourceTime_s) const;
    /// The newest sample at a time of the steady clock; empty if it is no longer stored.
    [[nodiscard]] std::optional<std::size_t> newestAt(std::int64_t time_ns) const;
    /// Shortest time between two samples that is a gap.
    [[nodiscard]] double longestStep_s() const;

protected:
    [[nodiscard]] std::size_t slot(std::size_t index) const {
        const std::size_t position = m_first + index;
        return position < m_capacity ? position : position - m_capacity;
    }
    [[nodiscard]] std::size_t capacity() const { return m_capacity; }

private:
    /// Number of leading samples for which isBefore is true.
    template <typename IsBefore>
    [[nodiscard]] std::size_t countWhile(const IsBefore& isBefore) const;
    /// Decides how a sample follows the newest one and returns its chart time.
    double follow(const SampleTime& sample, Break& before);

    std::size_t m_capacity;
    std::size_t m_first = 0;
    std::size_t m_size = 0;
    std::uint64_t m_appended = 0;
    double m_period_s = 0.0; ///< of the stream, smoothed; 0 unknown
    std::vector<double> m_time_s;
    std::vector<double> m_sourceTime_s;
    std::vector<std::int64_t> m_time_ns;
    std::vector<std::vector<double>> m_values;
    std::vector<Break> m_breaks;
};

} // namespace teleta::charts
