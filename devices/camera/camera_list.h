// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::camera {

/// A camera that the kernel knows.
struct CameraInfo {
    int number = 0;                     ///< N of /dev/videoN, as CameraConfig::source
    std::string name;                   ///< what its driver says; empty: not known
    std::optional<core::Error> error{}; ///< why it cannot be opened
};

/// Nodes of V4L2 that give pictures, in order of number; a camera's nodes for other data are passed over.
/// Asks each driver what it is and takes no picture. Thread: any but the GUI's.
[[nodiscard]] std::vector<CameraInfo> listCameras();

/// What a camera or a video says of itself and what its first frames show.
struct CameraProbe {
    int width_px = 0;
    int height_px = 0;
    double nominalRate_Hz = 0.0;             ///< as it is stated; 0: unknown
    std::optional<double> measuredRate_Hz{}; ///< of a camera, over its first frames
};

/// Opens a camera, or a video, and takes frames for a second at most. width_px, height_px, rate_Hz: asked of
/// a camera; 0: its own. Waits as long as the driver does for a camera that gives no frame. Error: as
/// VideoStream::open; unavailable when no frame comes.
[[nodiscard]] core::Expected<CameraProbe> probeCamera(const std::string& source, int width_px, int height_px,
                                                      double rate_Hz);

} // namespace teleta::camera
