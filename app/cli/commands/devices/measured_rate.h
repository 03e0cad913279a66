// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"

#include <optional>

namespace teleta::core {
class CameraSource;
}

namespace teleta::cli {

/// What came from a source, over a second from its first frame on.
struct SeenFrames {
    std::optional<double> rate_Hz; ///< empty: fewer than two frames came
    core::DeviceStatus status;     ///< at the end, while the source still ran
    // Of the last picture of a camera.
    int width_px = 0;
    int height_px = 0;
};

/// Starts a source, waits at most three seconds for its first frame, and stops it again. An interruption ends
/// it. Thread: one.
[[nodiscard]] SeenFrames lookAt(core::TactileSource& array);
[[nodiscard]] SeenFrames lookAt(core::CameraSource& camera);

} // namespace teleta::cli
