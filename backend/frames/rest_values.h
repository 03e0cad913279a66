// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/frames/frame_series.h"

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

} // namespace teleta::frames
