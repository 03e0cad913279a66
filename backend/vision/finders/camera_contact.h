// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <limits>
#include <vector>

namespace teleta::vision {

/// One place where something presses on the skin, as seen in one frame. Points are in the sensor frame {s}.
struct CameraContact {
    int id = 0; ///< > 0 once assigned, see ContactIdentities
    Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
    double area_px = 0.0;                ///< area inside the contour
    std::vector<cv::Point2f> contour_px; ///< closed
    bool located = false; ///< the ray of the centre meets the skin; only then are the following members known
    Eigen::Vector3d p_Sensor_Centre_m = Eigen::Vector3d::Zero(); ///< on the skin at rest
    double sd_m = std::numeric_limits<double>::quiet_NaN();      ///< standard deviation of the centre
    std::vector<Eigen::Vector3d> contour_m; ///< the contour on the skin, where it could be located
    double depth_m = std::numeric_limits<double>::quiet_NaN(); ///< largest inward displacement
    double depthNoise_m = 0.0; ///< standard deviation of the depth from frame to frame
    /// By how much the same places of the skin have moved inwards since the previous frame; NaN: unknown.
    double deepened_m = std::numeric_limits<double>::quiet_NaN();
};

} // namespace teleta::vision
