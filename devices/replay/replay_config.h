// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/threads/pacing_clock.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace teleta::replay {

/// Which recording is played, and how.
struct ReplayConfig {
    std::string path;
    core::ArrayLayout layout;
    std::string unit = "N"; ///< of the recorded values; the file does not say

    /// Frames are taken as recorded at this rate, whatever times the file has; > 0.
    std::optional<double> rate_Hz = std::nullopt;

    double speed = 1.0; ///< 0.01 .. 100, or infinity: as fast as the consumer takes them
    bool loop = false;
    bool autoplay = true; ///< false: shows the first frame and waits

    std::size_t queueBlocks = 256;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::replay
