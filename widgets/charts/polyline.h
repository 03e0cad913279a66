// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/charts/feature_history.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::charts {

struct PolylinePoint {
    double time_s = 0.0;
    double value = 0.0; ///< NaN lifts the pen
};

struct ValueRange {
    double low = 0.0, high = 0.0;
};

/// One column between two chart times as a line with few points: of each bucket the smallest and the largest
/// value, in the order of time, so that no peak is lost. Buckets lie at whole multiples of their width, so
/// that a scrolling line does not shimmer. The line is lifted at every break and at undefined values; a
/// single sample becomes a dash of one bucket.
///   period: values that repeat (an angle); a step of more than half of it lifts the pen. 0: none.
/// line: overwritten, its storage is kept. Returns the range of the values, empty when there are none.
/// bucket_s > 0. Cost: one pass over the samples in between. Thread: any (pure).
std::optional<ValueRange> makePolyline(const SampleHistory& history, std::size_t column, double from_s,
                                       double to_s, double bucket_s, double period,
                                       std::vector<PolylinePoint>& line);
inline std::optional<ValueRange> makePolyline(const FeatureHistory& history, Channel channel, double from_s,
                                              double to_s, double bucket_s, double period,
                                              std::vector<PolylinePoint>& line) {
    return makePolyline(history, static_cast<std::size_t>(channel), from_s, to_s, bucket_s, period, line);
}

/// Cuts away what lies outside of a range of values, exactly at its ends. A stretch outside lifts the pen.
/// range.low < range.high. A line inside of the range is left as it is. Thread: any (pure).
void cutPolyline(std::vector<PolylinePoint>& line, const ValueRange& range);

} // namespace teleta::charts
