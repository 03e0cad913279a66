// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/track_envelope.h"

#include <algorithm>
#include <utility>

namespace teleta::pattern {

namespace {

void widen(ValueRange& range, const ValueRange& other) {
    range = {std::min(range.low, other.low), std::max(range.high, other.high)};
}

} // namespace

TrackEnvelope::TrackEnvelope(Track lines)
    : m_lines(std::move(lines)) {
    std::vector<ValueRange> level;
    const auto summarise = [](std::size_t count, const auto& at) {
        std::vector<ValueRange> blocks;
        blocks.reserve(count / kBlock + 1);
        for (std::size_t i = 0; i < count; ++i) {
            if (i % kBlock == 0)
                blocks.push_back(at(i));
            else
                widen(blocks.back(), at(i));
        }
        return blocks;
    };
    level = summarise(m_lines.size(), [this](std::size_t i) {
        return ValueRange{m_lines[i].intensity, m_lines[i].intensity};
    });
    while (level.size() > 1) {
        m_levels.push_back(level);
        level = summarise(level.size(), [&below = m_levels.back()](std::size_t i) { return below[i]; });
    }
}

void TrackEnvelope::include(ValueRange& range, std::size_t first, std::size_t last) const {
    const auto points = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i)
            widen(range, {m_lines[i].intensity, m_lines[i].intensity});
    };
    // Incomplete blocks are searched on this level, complete ones on the next.
    std::size_t level = 0;
    const auto looseEnds = [&](std::size_t from, std::size_t to) {
        if (level == 0) {
            points(from, to);
            return;
        }
        for (std::size_t i = from; i < to; ++i)
            widen(range, m_levels[level - 1][i]);
    };
    while (first < last) {
        const std::size_t firstBlock = (first + kBlock - 1) / kBlock;
        const std::size_t lastBlock = last / kBlock;
        if (level == m_levels.size() || firstBlock >= lastBlock) {
            looseEnds(first, last);
            return;
        }
        looseEnds(first, firstBlock * kBlock);
        looseEnds(lastBlock * kBlock, last);
        first = firstBlock;
        last = lastBlock;
        ++level;
    }
}

double TrackEnvelope::valueAt(double t_s) const {
    const auto next =
        std::upper_bound(m_lines.begin(), m_lines.end(), t_s,
                         [](double time_s, const Breakpoint& point) { return time_s < point.time_s; });
    if (next == m_lines.begin() || next == m_lines.end())
        return 0.0;
    const Breakpoint& a = *(next - 1);
    return a.intensity + (t_s - a.time_s) / (next->time_s - a.time_s) * (next->intensity - a.intensity);
}

ValueRange TrackEnvelope::over(double begin_s, double end_s) const {
    const double first = valueAt(begin_s);
    ValueRange range{first, first};
    const double last = valueAt(end_s);
    widen(range, {last, last});
    if (m_lines.empty())
        return range;
    if (begin_s <= m_lines.front().time_s || end_s >= m_lines.back().time_s)
        widen(range, {0.0, 0.0});
    const auto from =
        std::lower_bound(m_lines.begin(), m_lines.end(), begin_s,
                         [](const Breakpoint& point, double time_s) { return point.time_s < time_s; });
    const auto to = std::upper_bound(from, m_lines.end(), end_s, [](double time_s, const Breakpoint& point) {
        return time_s < point.time_s;
    });
    include(range, static_cast<std::size_t>(from - m_lines.begin()),
            static_cast<std::size_t>(to - m_lines.begin()));
    return range;
}

} // namespace teleta::pattern
