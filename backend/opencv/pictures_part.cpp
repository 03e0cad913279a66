// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/opencv/exported_parts.h"

#include <opencv2/imgcodecs.hpp>

const teleta::opencv::Pictures teleta_opencv_pictures{
    [](const std::string& path, const cv::Mat& picture) { return cv::imwrite(path, picture); },
    [](const cv::Mat& bytes, int flags) { return cv::imdecode(bytes, flags); },
    [](const std::string& extension, const cv::Mat& picture, std::vector<std::uint8_t>& bytes,
       const std::vector<int>& parameters) { return cv::imencode(extension, picture, bytes, parameters); }};
