// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/camera_model.h"

#include <Eigen/Core>

#include <cmath>

namespace teleta::cost {

/// A tube's point by its angle and height.
[[nodiscard]] inline Eigen::Vector3d tubePoint_m(double angle_rad, double z_m) {
    constexpr double kTubeRadius_m = 0.025;
    return {kTubeRadius_m * std::cos(angle_rad), kTubeRadius_m * std::sin(angle_rad), z_m};
}

/// What a camera that knows nothing answers.
[[nodiscard]] inline Eigen::Vector3d middleOfTube_m() {
    return {0.0, 0.0, 0.05};
}

/// Direction of a point in the camera's frame, from its parameters alone; not of unit length.
[[nodiscard]] inline Eigen::Vector3d exactDirection(const vision::CameraParameters& camera,
                                                    const Eigen::Vector3d& p_Sensor_m) {
    Eigen::Vector3d direction = p_Sensor_m - camera.p_Sensor_Camera_m;
    if (camera.mirrored)
        direction.y() = -direction.y();
    return camera.R_Camera_Sensor * direction;
}

/// The pixel of a point before the lens: the formula of the rational model written out once more, with more
/// digits than the code that is measured. z > 0.
[[nodiscard]] inline Eigen::Vector2d exactPixel(const vision::CameraParameters& camera,
                                                const Eigen::Vector3d& p_Sensor_m) {
    const Eigen::Matrix<long double, 3, 1> d = exactDirection(camera, p_Sensor_m).cast<long double>();
    const long double x = d.x() / d.z();
    const long double y = d.y() / d.z();
    const long double s = x * x + y * y;
    const vision::RationalDistortion& lens = camera.distortion;
    const long double k1 = lens.k1, k2 = lens.k2, k3 = lens.k3, k4 = lens.k4, k5 = lens.k5, k6 = lens.k6;
    const long double p1 = lens.p1, p2 = lens.p2;
    const long double q =
        (1.0L + k1 * s + k2 * s * s + k3 * s * s * s) / (1.0L + k4 * s + k5 * s * s + k6 * s * s * s);
    const long double u = q * x + 2.0L * p1 * x * y + p2 * (s + 2.0L * x * x);
    const long double v = q * y + p1 * (s + 2.0L * y * y) + 2.0L * p2 * x * y;
    return {static_cast<double>(camera.fx_px * u + camera.skew_px * v + camera.cx_px),
            static_cast<double>(camera.fy_px * v + camera.cy_px)};
}

} // namespace teleta::cost
