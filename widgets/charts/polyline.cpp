// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::charts {

namespace {

class Builder {
public:
    Builder(std::vector<PolylinePoint>& line, double bucket_s)
        : m_line(line)
        , m_bucket_s(bucket_s) {
        m_line.clear();
    }

    void add(double time_s, double value) {
        const double bucket = std::floor(time_s / m_bucket_s);
        m_last = {time_s, value};
        if (m_inBucket && bucket != m_bucket)
            flush();
        if (!m_inBucket) {
            m_bucket = bucket;
            m_low = m_high = {time_s, value};
            m_inBucket = true;
        } else if (value < m_low.value) {
            m_low = {time_s, value};
        } else if (value > m_high.value) {
            m_high = {time_s, value};
        }
    }

    void lift() {
        flush();
        if (m_inRun == 0)
            return;
        if (m_last.time_s > m_line.back().time_s)
            put(m_last);
        if (m_inRun == 1)
            m_line.push_back({m_last.time_s + m_bucket_s, m_last.value});
        m_line.push_back({m_line.back().time_s, std::numeric_limits<double>::quiet_NaN()});
        m_inRun = 0;
    }

    [[nodiscard]] std::optional<ValueRange> range() const { return m_range; }

private:
    void put(const PolylinePoint& point) {
        m_line.push_back(point);
        ++m_inRun;
        if (!m_range)
            m_range = ValueRange{point.value, point.value};
        m_range->low = std::min(m_range->low, point.value);
        m_range->high = std::max(m_range->high, point.value);
    }
    void flush() {
        if (!m_inBucket)
            return;
        m_inBucket = false;
        const bool lowFirst = m_low.time_s <= m_high.time_s;
        put(lowFirst ? m_low : m_high);
        if (m_low.time_s != m_high.time_s)
            put(lowFirst ? m_high : m_low);
    }

    std::vector<PolylinePoint>& m_line;
    double m_bucket_s;
    double m_bucket = 0.0;
    bool m_inBucket = false;
    PolylinePoint m_low, m_high, m_last;
    std::size_t m_inRun = 0;
    std::optional<ValueRange> m_range;
};

} // namespace

std::optional<ValueRange> makePolyline(const SampleHistory& history, std::size_t column, double from_s,
                                       double to_s, double bucket_s, double period,
                                       std::vector<PolylinePoint>& line) {
    Builder builder(line, bucket_s);
    // One more sample on each side, so that the line reaches the edges.
    std::size_t i = history.firstAt(from_s);
    i -= i > 0 ? 1 : 0;
    const double halfPeriod = 0.5 * period;
    double previous = std::numeric_limits<double>::quiet_NaN();
    for (bool beyond = false; i < history.size() && !beyond; ++i) {
        const double time_s = history.time_s(i);
        beyond = time_s > to_s;
        const double value = history.value(column, i);
        const bool wrapped = period > 0.0 && std::abs(value - previous) > halfPeriod;
        if (wrapped || history.breakBefore(i) != Break::none || !std::isfinite(value))
            builder.lift();
        if (std::isfinite(value))
            builder.add(time_s, value);
        previous = value;
    }
    builder.lift();
    return builder.range();
}

void cutPolyline(std::vector<PolylinePoint>& line, const ValueRange& range) {
    const auto outside = [&range](const PolylinePoint& p) {
        return p.value < range.low || p.value > range.high;
    };
    if (std::ranges::none_of(line, outside))
        return;
    std::vector<PolylinePoint> cut;
    cut.reserve(2 * line.size());
    const auto lift = [&cut](double time_s) {
        if (!cut.empty() && !std::isnan(cut.back().value))
            cut.push_back({time_s, std::numeric_limits<double>::quiet_NaN()});
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const PolylinePoint& to = line[i];
        const bool joined = i > 0 && !std::isnan(to.value) && !std::isnan(line[i - 1].value);
        if (joined && (outside(line[i - 1]) || outside(to))) {
            // The part of the segment between the two ends of the range, if there is one.
            const PolylinePoint& from = line[i - 1];
            const double rise = to.value - from.value;
            double first = 0.0, last = 1.0;
            if (rise != 0.0) {
                const double atLow = (range.low - from.value) / rise;
                const double atHigh = (range.high - from.value) / rise;
                first = std::max(first, std::min(atLow, atHigh));
                last = std::min(last, std::max(atLow, atHigh));
            } else {
                last = -1.0; // horizontal and outside
            }
            const auto at = [&](double share) {
                return PolylinePoint{std::lerp(from.time_s, to.time_s, share),
                                     std::lerp(from.value, to.value, share)};
            };
            if (first <= last) {
                if (outside(from)) {
                    lift(at(first).time_s);
                    cut.push_back(at(first));
                }
                if (outside(to))
                    cut.push_back(at(last));
            }
        }
        if (std::isnan(to.value) || outside(to))
            lift(cut.empty() ? to.time_s : cut.back().time_s);
        else
            cut.push_back(to);
    }
    line = std::move(cut);
}

} // namespace teleta::charts
