// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_file.h"

namespace teleta::python {

/// A camera as Python holds it. Thread: any (immutable).
struct Camera {
    vision::CameraFile file;
};

} // namespace teleta::python
