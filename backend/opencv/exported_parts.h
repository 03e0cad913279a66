// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/opencv/opencv_parts.h"

namespace teleta::opencv {

struct Video {
    std::unique_ptr<cv::VideoCapture> (*capture)();
};

struct Flow {
    cv::Ptr<cv::DISOpticalFlow> (*dense)(int preset);
};

} // namespace teleta::opencv

/// What the modules of this folder export; each constant has the name of its module.
extern "C" {
[[gnu::visibility("default")]] extern const teleta::opencv::Pictures teleta_opencv_pictures;
[[gnu::visibility("default")]] extern const teleta::opencv::Video teleta_opencv_video;
[[gnu::visibility("default")]] extern const teleta::opencv::Flow teleta_opencv_flow;
}
