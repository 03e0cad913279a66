// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::signal {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Collects the points of a line.
class LineBuilder {
public:
    LineBuilder(std::vector<Sample>& line, double bucket_s)
        : m_line(line)
        , m_bucket_s(bucket_s) {
        m_line.clear();
    }
    void add(const Sample& sample) {
        m_line.push_back(sample);
        ++m_inRun;
        if (!m_range)
            m_range = ValueRange{sample.value, sample.value};
        m_range->low = std::min(m_range->low, sample.value);
        m_range->high = std::max(m_range->high, sample.value);
    }
    void lift() {
        if (m_inRun == 0)
            return;
        if (m_inRun == 1)
            m_line.push_back({m_line.back().time_s + m_bucket_s, m_line.back().value});
        m_line.push_back({m_line.back().time_s, kNaN});
        m_inRun = 0;
    }
    [[nodiscard]] std::optional<ValueRange> range() const { return m_range; }

private:
    std::vector<Sample>& m_line;
    double m_bucket_s;
    std::size_t m_inRun = 0;
    std::optional<ValueRange> m_range;
};

} // namespace

void Series::append(double time_s, double value) {
    Chunk& chunk = m_tail;
    const auto place = static_cast<std::uint16_t>(chunk.time_s.size());
    if (!empty())
        time_s = std::max(time_s, this->time_s(size() - 1));
    if (!std::isfinite(value))
        value = kNaN;
    chunk.time_s.push_back(time_s);
    chunk.value.push_back(value);
    if (place % kLeaf == 0)
        chunk.leaves.emplace_back();
    for (Extremes* part : {&chunk.leaves.back(), &chunk.whole}) {
        if (std::isnan(value)) {
            part->gap = true;
            continue;
        }
        if (part->lowAt == Extremes::kNone || value < chunk.value[part->lowAt])
            part->lowAt = place;
        if (part->highAt == Extremes::kNone || value > chunk.value[part->highAt])
            part->highAt = place;
    }
    if (chunk.time_s.size() == kChunk) {
        m_full.push_back(std::make_shared<const Chunk>(std::exchange(m_tail, {})));
        dropOld();
    }
}

void Series::lift() {
    if (!empty() && !std::isnan(value(size() - 1)))
        append(time_s(size() - 1), kNaN);
}

void Series::setCapacity(std::size_t samples) {
    m_capacity = samples;
    dropOld();
}

void Series::dropOld() {
    while (!m_full.empty() && size() >= m_capacity + kChunk) {
        m_full.pop_front();
        m_dropped += kChunk;
    }
}

std::size_t Series::firstAt(double time_s, std::size_t from) const {
    std::size_t low = from, step = 1;
    // What is looked for is often near.
    while (low + step < size() && this->time_s(low + step) < time_s) {
        low += step;
        step *= 2;
    }
    std::size_t high = std::min(low + step, size());
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (this->time_s(middle) < time_s)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

std::optional<double> Series::at(double time_s) const {
    const std::size_t after = firstAt(time_s);
    if (after == size())
        return std::nullopt;
    if (this->time_s(after) == time_s || after == 0)
        return this->time_s(after) == time_s && !std::isnan(value(after)) ? std::optional(value(after))
                                                                          : std::nullopt;
    if (std::isnan(value(after)) || std::isnan(value(after - 1)))
        return std::nullopt;
    const bool earlier = time_s - this->time_s(after - 1) < this->time_s(after) - time_s;
    return value(earlier ? after - 1 : after);
}

std::optional<double> Series::newest() const {
    return empty() || std::isnan(value(size() - 1)) ? std::nullopt : std::optional(value(size() - 1));
}

Series::Found Series::extremes(std::size_t first, std::size_t last) const {
    Found found;
    const auto take = [&](const Chunk& chunk, std::size_t begin, const Extremes& part) {
        found.gap = found.gap || part.gap;
        if (part.lowAt == Extremes::kNone)
            return;
        const double low = chunk.value[part.lowAt], high = chunk.value[part.highAt];
        if (found.lowAt == Found::kNone || low < found.low) {
            found.low = low;
            found.lowAt = begin + part.lowAt;
        }
        if (found.highAt == Found::kNone || high > found.high) {
            found.high = high;
            found.highAt = begin + part.highAt;
        }
    };
    for (std::size_t i = first; i < last;) {
        const Chunk& chunk = chunkOf(i);
        const std::size_t place = i % kChunk, begin = i - place;
        if (place == 0 && last - i >= kChunk) {
            take(chunk, begin, chunk.whole);
            i += kChunk;
        } else if (place % kLeaf == 0 && last - i >= kLeaf) {
            take(chunk, begin, chunk.leaves[place / kLeaf]);
            i += kLeaf;
        } else {
            const auto at =
                std::isnan(chunk.value[place]) ? Extremes::kNone : static_cast<std::uint16_t>(place);
            take(chunk, begin, {at, at, at == Extremes::kNone});
            ++i;
        }
    }
    return found;
}

std::optional<ValueRange> Series::range(std::size_t first, std::size_t last) const {
    const Found found = extremes(first, std::min(last, size()));
    return found.lowAt == Found::kNone ? std::nullopt : std::optional(ValueRange{found.low, found.high});
}

std::optional<ValueRange> Series::line(double from_s, double to_s, double bucket_s,
                                       std::vector<Sample>& line) const {
    LineBuilder builder(line, bucket_s);
    std::size_t i = firstAt(from_s);
    i -= i > 0 ? 1 : 0;
    const std::size_t end = std::min(size(), firstAt(to_s) + 1);
    const bool few = static_cast<double>(end - i) <= 2.0 * (to_s - from_s) / bucket_s;
    while (i < end) {
        if (few) {
            if (std::isnan(value(i)))
                builder.lift();
            else
                builder.add({time_s(i), value(i)});
            ++i;
            continue;
        }
        const double border_s = (std::floor(time_s(i) / bucket_s) + 1.0) * bucket_s;
        const std::size_t next = std::min(end, std::max(i + 1, firstAt(border_s, i)));
        const Found found = extremes(i, next);
        if (std::isnan(value(i)))
            builder.lift();
        if (found.lowAt != Found::kNone) {
            const auto [early, late] = std::minmax(found.lowAt, found.highAt);
            builder.add({time_s(early), value(early)});
            if (late != early)
                builder.add({time_s(late), value(late)});
        }
        if (found.gap)
            builder.lift();
        i = next;
    }
    builder.lift();
    return builder.range();
}

} // namespace teleta::signal
