// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/colour_image.h"

#include <cstdint>

namespace teleta::pipeline {

/// The newest picture of a scene camera.
struct SceneCameraSnapshot {
    core::ColourImage image;
    std::int64_t time_ns = 0;      ///< steady clock at its read
    double capture_s = 0.0;        ///< the camera's own time
    std::uint64_t frame = 0;       ///< its number
    std::uint64_t pictures = 0;    ///< since the start
    std::uint64_t undecodable = 0; ///< frames without a picture
};

} // namespace teleta::pipeline
