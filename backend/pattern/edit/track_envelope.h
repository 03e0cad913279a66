// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/edit/range_levels.h"
#include "backend/pattern/model/pattern.h"

#include <algorithm>

namespace teleta::pattern {

/// Lowest and highest value in an interval of time.
struct ValueRange {
    double low = 0.0;
    double high = 0.0;

    void join(const ValueRange& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
    bool operator==(const ValueRange&) const = default;
};

/// Lowest and highest intensity of a track in any interval of time, so that drawing a long pattern takes one
/// query per column of pixels, which takes O(log breakpoints). Thread: any (immutable).
class TrackEnvelope {
public:
    TrackEnvelope() = default;
    /// lines: straight lines (linearised()), times never decrease.
    explicit TrackEnvelope(Track lines);

    /// Range over [begin, end] with both sides of steps; 0 where the track is off. begin_s <= end_s.
    [[nodiscard]] ValueRange over(double begin_s, double end_s) const;

private:
    [[nodiscard]] ValueRange at(std::size_t point) const {
        return {m_lines[point].intensity, m_lines[point].intensity};
    }
    [[nodiscard]] double valueAt(double t_s) const;

    Track m_lines;
    RangeLevels<ValueRange> m_levels;
};

} // namespace teleta::pattern
