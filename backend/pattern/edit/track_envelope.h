// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <vector>

namespace teleta::pattern {

/// Lowest and highest value in a stretch of time.
struct ValueRange {
    double low = 0.0;
    double high = 0.0;

    bool operator==(const ValueRange&) const = default;
};

/// Lowest and highest intensity of a track in any stretch of time, so that a long pattern is drawn with one
/// look a column of pixels. Ranges of blocks of breakpoints, and of blocks of those, are made once; a look
/// takes O(log breakpoints). Thread: any, it does not change after construction.
class TrackEnvelope {
public:
    TrackEnvelope() = default;
    /// lines: straight lines (linearised()), times never decrease.
    explicit TrackEnvelope(Track lines);

    /// Over [begin, end], steps from both sides, 0 where the track is off. begin_s <= end_s.
    [[nodiscard]] ValueRange over(double begin_s, double end_s) const;

private:
    static constexpr std::size_t kBlock = 32;

    void include(ValueRange& range, std::size_t first, std::size_t last) const;
    [[nodiscard]] double valueAt(double t_s) const;

    Track m_lines;
    std::vector<std::vector<ValueRange>> m_levels; ///< each of kBlock of the level below
};

} // namespace teleta::pattern
