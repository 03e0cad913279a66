// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"
#include "devices/camera/video_stream.h"

#include <cstddef>
#include <memory>
#include <string>

namespace teleta::camera {

/// Which camera, or which recorded video.
struct CameraConfig {
    std::string source; ///< a file, a pattern of numbered images (frame_%04d.png) or the number of a camera
    int width_px = 0;   ///< asked of a camera; 0: its own
    int height_px = 0;
    double rate_Hz = 0.0;
    VideoChannel channel = VideoChannel::grey; ///< of coloured pictures
    bool paced = true;       ///< a file is played at its own rate; otherwise as fast as frames are taken
    bool loop = false;       ///< of a file
    int firstRetry_ms = 250; ///< after a camera was lost; doubled with each attempt
    int longestRetry_ms = 5000;
    std::size_t queueFrames = 8;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::camera
