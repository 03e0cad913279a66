// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/arm_device.h"
#include "backend/core/device.h"
#include "backend/core/pacing_clock.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace teleta::replay {

/// Which streams of a recording are played, and how.
struct RecordedConfig {
    std::string path;
    std::size_t arrayStream = 0; ///< number of the stream in the recording
    core::SourceDescription array;
    std::optional<std::size_t> jointStream; ///< of the arm that wears the array
    core::ArmDescription arm;

    double speed = 1.0; ///< 0.01 .. 100, or infinity: as fast as the consumer takes them
    bool loop = false;
    bool autoplay = true; ///< false: shows the first frame and waits

    std::size_t queueBlocks = 256;
    std::size_t queueJoints = 16'384;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::replay
