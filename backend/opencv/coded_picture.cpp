// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/opencv/coded_picture.h"

#include <algorithm>
#include <cstdint>
#include <optional>

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

struct Head {
    std::size_t width = 0;
    std::size_t height = 0;
    bool hasColours = false;
};

std::optional<Head> pngHead(std::string_view bytes) {
    constexpr std::size_t kHead = 26;
    constexpr std::uint8_t kColours = 2; ///< bit of the colour type; a palette has it, too
    if (bytes.size() < kHead)
        return std::nullopt;
    return Head{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4),
                (static_cast<std::uint8_t>(bytes[25]) & kColours) != 0};
}

std::optional<Head> jpegHead(std::string_view bytes) {
    // The segments up to that of the frame: ff, marker, length with itself, precision, height, width, number
    // of components.
    constexpr std::size_t kFrameHead = 10;
    for (std::size_t at = kJpeg.size(); at + kFrameHead <= bytes.size();) {
        const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
        if (static_cast<std::uint8_t>(bytes[at]) != 0xff)
            return std::nullopt;
        const bool isFrame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (isFrame)
            return Head{bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2),
                        static_cast<std::uint8_t>(bytes[at + 9]) > 1};
        at += marker == 0xff ? 1 : 2 + std::max<std::size_t>(bigEndian(bytes, at + 2, 2), 2);
    }
    return std::nullopt;
}

std::optional<Head> headOf(std::string_view bytes) {
    if (bytes.starts_with(kPng))
        return pngHead(bytes);
    return bytes.starts_with(kJpeg) ? jpegHead(bytes) : std::nullopt;
}

} // namespace

bool isPicture(std::string_view bytes, std::size_t mostPixels) {
    const auto head = headOf(bytes);
    return head && head->width > 0 && head->height > 0 && head->width <= mostPixels / head->height;
}

bool isColourPicture(std::string_view bytes) {
    const auto head = headOf(bytes);
    return head && head->hasColours;
}

} // namespace teleta::opencv
