// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/opencv/coded_picture.h"

#include <algorithm>
#include <cstdint>

namespace teleta::opencv {

namespace {

constexpr std::string_view kPng{"\x89PNG\r\n\x1a\n", 8};
constexpr std::string_view kJpeg{"\xff\xd8", 2};

std::size_t bigEndian(std::string_view bytes, std::size_t at, std::size_t size) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
}

} // namespace

bool isPicture(std::string_view bytes, std::size_t mostPixels) {
    const auto fits = [mostPixels](std::size_t width, std::size_t height) {
        return width > 0 && height > 0 && width <= mostPixels / height;
    };
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

} // namespace teleta::opencv
