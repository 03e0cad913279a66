// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace teleta::vision {

/// A pixel and the point that it shows, in the sensor frame {s}.
struct CalibrationPair {
    Eigen::Vector2d pixel;
    Eigen::Vector3d p_Sensor_m;
};

} // namespace teleta::vision
