// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <limits>
#include <vector>

namespace teleta::vision {

/// One place where something presses on the skin, as one frame shows it. Frame {s} of the sensor.
struct CameraContact {
    int id = 0; ///< > 0 once it was given one, see ContactIdentities
    Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
    double area_px = 0.0;                ///< inside the contour
    std::vector<cv::Point2f> contour_px; ///< closed
    bool located = false;                ///< the centre's ray meets the skin, and what follows is known
    Eigen::Vector3d p_Sensor_Centre_m = Eigen::Vector3d::Zero(); ///< on the skin at rest
    double sd_m = std::numeric_limits<double>::quiet_NaN();      ///< of the centre, 1 sigma
    std::vector<Eigen::Vector3d> contour_m;                      ///< on the skin, where it could be located
    double depth_m = std::numeric_limits<double>::quiet_NaN(); ///< largest inward displacement that was seen
    double depthNoise_m = 0.0;                                 ///< of the depth from frame to frame, 1 sigma
    /// By how much the same places of the skin have become deeper since the frame before; NaN: not known.
    double deepened_m = std::numeric_limits<double>::quiet_NaN();
};

} // namespace teleta::vision
