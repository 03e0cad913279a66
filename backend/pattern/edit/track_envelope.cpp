// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/track_envelope.h"

#include <algorithm>
#include <utility>

namespace teleta::pattern {

TrackEnvelope::TrackEnvelope(Track lines)
    : m_lines(std::move(lines))
    , m_levels(m_lines.size(), [this](std::size_t i) { return at(i); }) {
}

double TrackEnvelope::valueAt(double t_s) const {
    const auto next = std::ranges::upper_bound(m_lines, t_s, {}, &Breakpoint::time_s);
    if (next == m_lines.begin() || next == m_lines.end())
        return 0.0;
    const Breakpoint& a = *(next - 1);
    return a.intensity + (t_s - a.time_s) / (next->time_s - a.time_s) * (next->intensity - a.intensity);
}

ValueRange TrackEnvelope::over(double begin_s, double end_s) const {
    const double first = valueAt(begin_s);
    ValueRange range{first, first};
    const double last = valueAt(end_s);
    range.join({last, last});
    if (m_lines.empty())
        return range;
    if (begin_s <= m_lines.front().time_s || end_s >= m_lines.back().time_s)
        range.join({0.0, 0.0});
    const auto from = std::ranges::lower_bound(m_lines, begin_s, {}, &Breakpoint::time_s);
    const auto to = std::ranges::upper_bound(from, m_lines.end(), end_s, {}, &Breakpoint::time_s);
    m_levels.join(range, static_cast<std::size_t>(from - m_lines.begin()),
                  static_cast<std::size_t>(to - m_lines.begin()), [this](std::size_t i) { return at(i); });
    return range;
}

} // namespace teleta::pattern
