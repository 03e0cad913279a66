// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/charts/sample_history.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::charts {

/// Conversion of a channel's SI value to the number on the axis.
struct Display {
    double scale = 1.0;
    bool root = false; ///< take the square root before scaling: eigenvalues are shown as standard deviations

    [[nodiscard]] double of(double value) const { return scale * (root ? std::sqrt(value) : value); }
};

/// How a column of a history is drawn.
struct CurveStyle {
    std::size_t column = 0;
    Display display;
    int colour = 1;      ///< identity colour; 0 the colour of faint text
    bool dashed = false; ///< a reference, not a measurement
    double period = 0.0; ///< of the SI value, for angles
    bool whole = false;  ///< a count
};

struct PolylinePoint {
    double time_s = 0.0;
    double value = 0.0; ///< NaN lifts the pen
};

struct ValueRange {
    double low = 0.0, high = 0.0;
};

/// One column between two chart times as a line with few points: the smallest and the largest value of each
/// bucket, in order of time, so that no peak is lost. Buckets lie at whole multiples of their width, so that
/// a scrolling line does not shimmer. The line is interrupted at every break and at undefined values; a
/// single sample becomes a dash of one bucket.
///   period: of values that wrap around (an angle); a step of more than half of it interrupts the line. 0:
///   none.
/// line: overwritten, its storage is reused. Returns the range of the values, empty if there are none.
/// bucket_s > 0. Cost: one pass over the samples. Thread: any (pure).
std::optional<ValueRange> makePolyline(const SampleHistory& history, std::size_t column, double from_s,
                                       double to_s, double bucket_s, double period,
                                       std::vector<PolylinePoint>& line);

/// Clips a line to a range of values, exactly at its ends; it is interrupted outside. range.low < range.high.
/// Thread: any (pure).
void cutPolyline(std::vector<PolylinePoint>& line, const ValueRange& range);

} // namespace teleta::charts
