// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"
#include "devices/mouse3d/mouse3d_motion.h"

#include <cstdint>
#include <memory>

namespace teleta::mouse3d {

struct Mouse3dConfig {
    MotionLimits limits{};
    int deadManButton = 0; ///< 0 .. 31; motion counts only while it is held
    /// A deflected cap reports without pause; one that is silent for so long counts as at rest.
    std::int64_t axesLifetime_ns = 200'000'000;
    /// A cap at rest does not report. A dead-man button that is held while nothing comes for so long counts
    /// as let go: its release may have been lost.
    std::int64_t restLifetime_ns = 3'000'000'000;
    int readTimeout_ms = 50; ///< after which the worker looks at its stop token
    std::int64_t firstRetry_ns = 250'000'000;
    std::int64_t longestRetry_ns = 2'000'000'000;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::mouse3d
