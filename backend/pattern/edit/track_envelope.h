// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <vector>

namespace teleta::pattern {

/// Lowest and highest value in an interval of time.
struct ValueRange {
    double low = 0.0;
    double high = 0.0;

    bool operator==(const ValueRange&) const = default;
};

/// Lowest and highest intensity of a track in any interval of time, so that drawing a long pattern takes one
/// query per column of pixels. The ranges of blocks of breakpoints, and of blocks of blocks, are precomputed;
/// a query takes O(log breakpoints). Thread: any (immutable).
class TrackEnvelope {
public:
    TrackEnvelope() = default;
    /// lines: straight lines (linearised()), times never decrease.
    explicit TrackEnvelope(Track lines);

    /// Range over [begin, end] with both sides of steps; 0 where the track is off. begin_s <= end_s.
    [[nodiscard]] ValueRange over(double begin_s, double end_s) const;

private:
    static constexpr std::size_t kBlock = 32;

    void include(ValueRange& range, std::size_t first, std::size_t last) const;
    [[nodiscard]] double valueAt(double t_s) const;

    Track m_lines;
    std::vector<std::vector<ValueRange>> m_levels; ///< each entry covers kBlock of the level below
};

} // namespace teleta::pattern
