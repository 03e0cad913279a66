// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/frame_series.h"

#include <cstdint>
#include <span>
#include <vector>

namespace teleta::frames {

/// How the value of each taxel without load follows from frames.
enum class RestRule {
    mean,   ///< of all frames: of a recording in which nothing touches the array
    median, ///< of all frames: a taxel is touched in less than half of them
    first,  ///< the mean over the first kFirst_s: nothing touches the array at the start
};

inline constexpr double kFirst_s = 0.5;

/// The rest value of each taxel, of its finite values; NaN for a taxel that has none, which is dead then.
/// Thread: any (pure).
[[nodiscard]] std::vector<float> restValues(const FrameSeries& frames, RestRule rule);

/// The rest value of each taxel where no frame shows the empty array: where its readings lie closest together
/// at its unloaded end. Each taxel must be untouched in at least one frame in ten, of 200 or more. The value
/// is the middle of the shortest interval that holds one reading in twenty, at least ten, in the unloaded
/// half of the taxel's range. A taxel whose range is less than a quarter of the widest one was never touched;
/// its median is taken. NaN for a taxel without finite values, which is dead then.
/// Error: refused with the number of the first taxel whose readings do not lie closer together there than
/// evenly spread loads would, or reach further below: it was touched nearly always, or nothing was. A taxel
/// that was never let go and rests often at its least load cannot be told from one at rest.
/// Thread: any (pure).
///   inverted: the raw values fall under load. dead: 1 for each taxel that needs no value, or empty.
[[nodiscard]] core::Expected<std::vector<float>> untouchedValues(const FrameSeries& frames, bool inverted,
                                                                 std::span<const std::uint8_t> dead = {});

} // namespace teleta::frames
