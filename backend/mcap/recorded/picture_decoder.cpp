// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/picture_decoder.h"

#include "backend/opencv/opencv_parts.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace teleta::mcap {

namespace {

constexpr std::string_view kPng{"\x89PNG\r\n\x1a\n", 8};
constexpr std::string_view kJpeg{"\xff\xd8", 2};

std::size_t bigEndian(std::string_view bytes, std::size_t at, std::size_t size) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
}

bool fits(std::size_t width, std::size_t height) {
    return width > 0 && height > 0 && width <= kMostPixels / height;
}

/// Before it is decoded, since a few bytes can claim any size.
bool hasFitSize(std::string_view bytes) {
    constexpr std::size_t kPngHead = 24;
    if (bytes.starts_with(kPng))
        return bytes.size() >= kPngHead && fits(bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4));
    if (!bytes.starts_with(kJpeg))
        return false;
    // The segments up to that of the frame: ff, marker, length with itself, precision, height, width.
    constexpr std::size_t kFrameHead = 9;
    for (std::size_t at = kJpeg.size(); at + kFrameHead <= bytes.size();) {
        const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
        if (static_cast<std::uint8_t>(bytes[at]) != 0xff)
            return false;
        const bool isFrame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (isFrame)
            return fits(bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2));
        at += marker == 0xff ? 1 : 2 + std::max<std::size_t>(bigEndian(bytes, at + 2, 2), 2);
    }
    return false;
}

} // namespace

std::optional<core::GreyImage> decodePicture(std::string_view bytes) {
    if (!hasFitSize(bytes))
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
