// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/device/device.h"
#include "backend/core/threads/pacing_clock.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace teleta::replay {

/// Which streams of a recording are played, and how.
struct RecordedConfig {
    /// A part of a recording. All sources of a recording that are played together have the same one.
    struct Span {
        std::int64_t first_ns = 0;
        std::int64_t last_ns = 0;
    };

    std::string path;
    std::size_t stream = 0; ///< number in the recording: an array, or a camera
    core::SourceDescription array;
    std::optional<std::size_t> jointStream; ///< of the arm that wears the array
    core::ArmDescription arm;
    std::optional<core::CameraDescription> camera; ///< the stream is that of a camera, not of an array
    std::optional<std::size_t> referenceStream;    ///< of the camera; it begins with the first one of these
    std::optional<Span> span; ///< that is played; empty: from its first frame to its last

    double speed = 1.0; ///< 0.01 .. 100, or infinity: as fast as the consumer takes them
    bool loop = false;
    bool autoplay = true; ///< false: shows the first frame and waits

    std::size_t queueBlocks = 256;
    std::size_t queueJoints = 16'384;
    std::size_t queuePictures = 8;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::replay
