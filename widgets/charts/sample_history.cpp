// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/sample_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::charts {

namespace {

constexpr double kShortestGap_s = 0.1;
constexpr double kPeriodsOfAGap = 5.0;
constexpr double kShortestJump_s = 0.25;
constexpr double kLongestJump_s = 2.0;
constexpr double kSmoothing = 0.05;

} // namespace

SampleHistory::SampleHistory(std::size_t columns, std::size_t capacity)
    : m_capacity(std::max<std::size_t>(1, capacity))
    , m_time_s(m_capacity)
    , m_sourceTime_s(m_capacity)
    , m_time_ns(m_capacity)
    , m_values(columns, std::vector<double>(m_capacity))
    , m_breaks(m_capacity) {
}

void SampleHistory::clear() {
    m_first = m_size = 0;
    m_period_s = 0.0;
}

double SampleHistory::longestStep_s() const {
    return std::max(kShortestGap_s, kPeriodsOfAGap * m_period_s);
}

double SampleHistory::follow(const SampleTime& sample, Break& before) {
    before = Break::none;
    if (m_size == 0) {
        before = Break::jump;
        return 0.0;
    }
    const double newest_s = newestTime_s();
    const double step_s = sample.sourceTime_s - sourceTime_s(m_size - 1);
    if (sample.discontinuity || !(step_s >= 0.0)) {
        before = Break::jump;
        const double passed_s = static_cast<double>(sample.time_ns - time_ns(m_size - 1)) * 1e-9;
        return newest_s + std::clamp(passed_s, kShortestJump_s, kLongestJump_s);
    }
    if (m_period_s > 0.0 && step_s > longestStep_s())
        before = Break::missing;
    else if (step_s > 0.0)
        m_period_s = m_period_s > 0.0 ? m_period_s + kSmoothing * (step_s - m_period_s) : step_s;
    return newest_s + step_s;
}

void SampleHistory::append(const SampleTime& time, std::span<const double> values) {
    Break before = Break::none;
    const double chartTime_s = follow(time, before);
    if (m_size == m_capacity)
        m_first = m_first + 1 == m_capacity ? 0 : m_first + 1;
    else
        ++m_size;
    ++m_appended;

    const std::size_t s = slot(m_size - 1);
    m_time_s[s] = chartTime_s;
    m_sourceTime_s[s] = time.sourceTime_s;
    m_time_ns[s] = time.time_ns;
    m_breaks[s] = before;
    for (std::size_t column = 0; column < m_values.size(); ++column)
        m_values[column][s] =
            column < values.size() ? values[column] : std::numeric_limits<double>::quiet_NaN();
}

template <typename IsBefore>
std::size_t SampleHistory::countWhile(const IsBefore& isBefore) const {
    std::size_t low = 0;
    std::size_t high = m_size;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (isBefore(middle))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

std::size_t SampleHistory::firstAt(double time) const {
    return countWhile([&](std::size_t index) { return time_s(index) < time; });
}

std::optional<std::size_t> SampleHistory::newestAt(std::int64_t time) const {
    const std::size_t until = countWhile([&](std::size_t index) { return time_ns(index) <= time; });
    return until > 0 ? std::optional(until - 1) : std::nullopt;
}

std::optional<std::size_t> SampleHistory::nearest(double time) const {
    if (m_size == 0)
        return std::nullopt;
    std::size_t index = std::min(firstAt(time), m_size - 1);
    if (index > 0 && time - time_s(index - 1) < time_s(index) - time)
        --index;
    if (std::abs(time_s(index) - time) > longestStep_s())
        return std::nullopt;
    return index;
}

std::optional<std::size_t> SampleHistory::nearestSource(double source) const {
    std::optional<std::size_t> best;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = m_size; i-- > 0;) {
        const double d = std::abs(sourceTime_s(i) - source);
        if (d < distance) {
            distance = d;
            best = i;
        }
        if (best && breakBefore(i) == Break::jump && distance <= longestStep_s())
            break; // an earlier pass over the same part of a recording does not count
    }
    return best;
}

} // namespace teleta::charts
