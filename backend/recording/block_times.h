// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"

#include <algorithm>
#include <cmath>

namespace teleta::recording {

/// Whether frames may form a block of a recording: steady times that never decrease and finite source times.
/// The reader treats anything else as damage. Thread: any (pure).
[[nodiscard]] inline bool hasTimesInOrder(const core::TappedFrames& block) {
    return std::ranges::is_sorted(block.time_ns) &&
           std::ranges::all_of(block.sourceTime_s, [](double time_s) { return std::isfinite(time_s); });
}

} // namespace teleta::recording
