// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/camera/skin/printed_dots.h"
#include "backend/vision/camera/camera_model.h"

#include <opencv2/core.hpp>

#include <functional>
#include <string_view>
#include <vector>

namespace teleta::simulation {

/// One imperfection of the camera inside the tube. Each sets what it acts on. Thread: one.
struct CameraEffect {
    std::string_view name;

    // Once, in this order.
    std::function<void(vision::CameraParameters& camera)> changeLens{};
    std::function<void(PrintedDots& dots)> changePrint{};
    /// light: factor of each pixel's brightness; places: angle and z of the skin behind it, NaN without any.
    std::function<void(cv::Mat1f& light, const cv::Mat2f& places)> changeLight{};

    /// The moments that a frame averages, in s before the end of the exposure; empty: one, at the end.
    std::vector<double> before_s{};

    /// Each frame from top to bottom, a few rows a call, in grey levels.
    std::function<void(cv::Mat1f& rows)> changeRows{};
};

} // namespace teleta::simulation
