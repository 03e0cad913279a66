// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"
#include "backend/vision/camera/camera_model.h"

namespace teleta::cost {

/// A camera like the data sheet's (160 degrees over 1640 x 1232), as one would mount it: another focal length
/// and principal point, a bent and decentred lens, any roll, a little tilt and offset, either handedness.
[[nodiscard]] vision::CameraParameters randomCamera(core::RandomStream& random);

} // namespace teleta::cost
