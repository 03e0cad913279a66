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

/// V4L2 nodes that deliver pictures, in order of number; a camera's nodes for other data are skipped.
/// Queries each driver without taking a picture. Thread: any but the GUI's.
[[nodiscard]] std::vector<CameraInfo> listCameras();

/// What a camera or a video reports and what its first frames show.
struct CameraProbe {
    int width_px = 0;
    int height_px = 0;
    double nominalRate_Hz = 0.0;             ///< as it is stated; 0: unknown
    std::optional<double> measuredRate_Hz{}; ///< of a camera, over its first frames
};

/// Opens a camera, or a video, and takes frames for a second at most. width_px, height_px, rate_Hz: requested
/// of a camera; 0: its own. Waits as long as the driver does for a camera without frames. Error: as
/// VideoStream::open; unavailable when no frame arrives.
[[nodiscard]] core::Expected<CameraProbe> probeCamera(const std::string& source, int width_px, int height_px,
                                                      double rate_Hz);

} // namespace teleta::camera
