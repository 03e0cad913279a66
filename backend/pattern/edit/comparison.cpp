// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/comparison.h"

#include "backend/pattern/model/bake.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

/// Walks along straight lines. It is asked for consecutive intervals with no breakpoint inside.
class Walker {
public:
    explicit Walker(const Track& lines)
        : m_lines(lines) {}

    /// Values at both ends, taken from inside the interval.
    std::pair<double, double> over(double begin_s, double end_s) {
        while (m_at < m_lines.size() && m_lines[m_at].time_s <= begin_s)
            ++m_at;
        if (m_at == 0 || m_at == m_lines.size())
            return {0.0, 0.0};
        const Breakpoint& a = m_lines[m_at - 1];
        const Breakpoint& b = m_lines[m_at];
        const auto at = [&](double t_s) {
            return a.intensity + (t_s - a.time_s) / (b.time_s - a.time_s) * (b.intensity - a.intensity);
        };
        return {at(begin_s), at(end_s)};
    }

private:
    const Track& m_lines;
    std::size_t m_at = 0;
};

std::vector<double> corners(const Track& a, const Track& b, double duration_s) {
    std::vector<double> times_s{0.0, duration_s};
    for (const Track* track : {&a, &b})
        for (const Breakpoint& point : *track)
            if (point.time_s > 0.0 && point.time_s < duration_s)
                times_s.push_back(point.time_s);
    std::ranges::sort(times_s);
    times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
    return times_s;
}

TactorDifference differenceOf(const Track& a, const Track& b, double duration_s) {
    TactorDifference difference;
    Walker first(a);
    Walker second(b);
    const std::vector<double> times_s = corners(a, b, duration_s);
    double squares = 0.0;
    const auto look = [&](double apart, double t_s) {
        if (std::abs(apart) > difference.largest) {
            difference.largest = std::abs(apart);
            difference.largestAt_s = t_s;
        }
    };
    for (std::size_t k = 1; k < times_s.size(); ++k) {
        const double begin_s = times_s[k - 1];
        const double end_s = times_s[k];
        const auto [a0, a1] = first.over(begin_s, end_s);
        const auto [b0, b1] = second.over(begin_s, end_s);
        const double d0 = a0 - b0;
        const double d1 = a1 - b1;
        look(d0, begin_s);
        look(d1, end_s);
        squares += (end_s - begin_s) * (d0 * d0 + d0 * d1 + d1 * d1) / 3.0;
    }
    difference.rms = duration_s > 0.0 ? std::sqrt(squares / duration_s) : 0.0;
    return difference;
}

} // namespace

core::Expected<Comparison> compared(const Pattern& a, const Pattern& b) {
    TELETA_TRY(const Tracks first, linearised(a));
    TELETA_TRY(const Tracks second, linearised(b));
    Comparison comparison;
    comparison.duration_s = std::max(a.duration_s, b.duration_s);
    double squares = 0.0;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        comparison.tactors[i] = differenceOf(first[i], second[i], comparison.duration_s);
        squares += comparison.tactors[i].rms * comparison.tactors[i].rms;
        if (comparison.tactors[i].largest >
            comparison.tactors[static_cast<std::size_t>(comparison.largestTactor)].largest)
            comparison.largestTactor = static_cast<int>(i);
    }
    comparison.rms = std::sqrt(squares / static_cast<double>(core::kTactors));
    return comparison;
}

} // namespace teleta::pattern
