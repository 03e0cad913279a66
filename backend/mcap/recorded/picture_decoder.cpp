// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/picture_decoder.h"

#include "backend/opencv/coded_picture.h"
#include "backend/opencv/opencv_parts.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <utility>

namespace teleta::mcap {

std::optional<core::GreyImage> decodePicture(std::string_view bytes, PngPixel pixel) {
    const bool isColour = pixel == PngPixel::colour;
    if (!opencv::isPicture(bytes, kMostPixels))
        return std::nullopt;
    const auto pictures = opencv::pictures();
    if (!pictures)
        return std::nullopt;
    cv::Mat pixels;
    try {
        // OpenCV takes no constant bytes, and does not change these.
        const cv::Mat coded(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
        pixels = (*pictures)->decode(coded, (isColour ? cv::IMREAD_COLOR : cv::IMREAD_GRAYSCALE) |
                                                cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
    if (pixels.empty() || pixels.type() != (isColour ? CV_8UC3 : CV_8UC1))
        return std::nullopt;
    if (isColour) {
        // OpenCV's order is blue, green, red.
        pixels.forEach<cv::Vec3b>([](cv::Vec3b& bgr, const int*) { std::swap(bgr[0], bgr[2]); });
        pixels = pixels.reshape(1);
    }
    return core::greyImageOf(std::move(pixels));
}

} // namespace teleta::mcap
