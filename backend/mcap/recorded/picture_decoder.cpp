// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/picture_decoder.h"

#include "backend/opencv/coded_picture.h"
#include "backend/opencv/opencv_parts.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <utility>

namespace teleta::mcap {

std::optional<core::GreyImage> decodePicture(std::string_view bytes) {
    if (!opencv::isPicture(bytes, kMostPixels))
        return std::nullopt;
    const auto pictures = opencv::pictures();
    if (!pictures)
        return std::nullopt;
    cv::Mat pixels;
    try {
        // OpenCV takes no constant bytes, and does not change these.
        const cv::Mat coded(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
        pixels = (*pictures)->decode(coded, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
    if (pixels.empty() || pixels.type() != CV_8UC1)
        return std::nullopt;
    return core::greyImageOf(std::move(pixels));
}

} // namespace teleta::mcap
