// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"
#include "backend/vision/camera/camera_model.h"

#include <Eigen/Core>

namespace teleta::cost {

/// A camera like the data sheet's (160 degrees over 1640 x 1232), as one would mount it: another focal length
/// and principal point, a bent and decentred lens, any roll, a little tilt and offset, either handedness.
[[nodiscard]] vision::CameraParameters randomCamera(core::RandomStream& random);

/// A point on the tube by its angle and height.
[[nodiscard]] Eigen::Vector3d tubePoint_m(double angle_rad, double z_m);

/// What a camera that knows nothing answers.
[[nodiscard]] Eigen::Vector3d middleOfTube_m();

/// Direction of a point in the camera's frame, from its parameters alone; not of unit length.
[[nodiscard]] Eigen::Vector3d exactDirection(const vision::CameraParameters& camera,
                                             const Eigen::Vector3d& p_Sensor_m);

/// The pixel of a point before the lens: the formula of the rational model written out once more, with more
/// digits than the code that is measured. z > 0.
[[nodiscard]] Eigen::Vector2d exactPixel(const vision::CameraParameters& camera,
                                         const Eigen::Vector3d& p_Sensor_m);

} // namespace teleta::cost
