// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/simulation/camera/gel/gel_renderer.h"

#include <opencv2/videoio.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace teleta::test {

/// A sensor file for the simulated gel.
inline const char* const kGelFile = "kind = \"marker_gel\"\n"
                                    "name = \"simulated\"\n"
                                    "grid = \"rectangular\"\n"
                                    "rows = 8\n"
                                    "columns = 10\n"
                                    "[plane]\n"
                                    "mm_per_px = 0.1\n";

/// How far the object under the gel drags what sticks to it, in pixels, in each frame of the video.
inline constexpr double kDraggedPerFrame_px = 0.5;
inline constexpr int kStillFrames = 8;

/// Writes a lossless video of a simulated gel that is at rest for 8 frames and dragged along u afterwards.
/// Returns false when it cannot be written.
inline bool writeGelVideo(const std::string& path, int frames) {
    simulation::GelRenderer renderer({});
    cv::Mat1b picture;
    cv::VideoWriter video(path, cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 25.0, {320, 240}, false);
    for (int i = 0; i < frames && video.isOpened(); ++i) {
        const double dragged_px = kDraggedPerFrame_px * std::max(0, i - kStillFrames + 1);
        std::vector<Eigen::Vector2d> places = renderer.rest_px();
        const simulation::GelContact contact{.centre_m = {160.0, 120.0},
                                             .radius_m = 70.0,
                                             .slip_m = {2.0 * dragged_px, 0.0},
                                             .stick = 0.70710678};
        for (Eigen::Vector2d& place : places)
            place += contact.displacement_m(place);
        renderer.draw(places, picture);
        video.write(picture);
    }
    return video.isOpened();
}

} // namespace teleta::test
