// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/colour_image.h"
#include "backend/core/error.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace teleta::picture {

/// Pixels of a picture, at most: 8192 x 8192.
inline constexpr std::size_t kMostPixels = std::size_t{1} << 26U;

/// A picture without compression, as sensor_msgs/Image has it. It refers to its bytes and owns none.
struct RawPicture {
    std::string_view encoding;
    std::size_t width_px = 0;
    std::size_t height_px = 0;
    std::size_t rowBytes = 0; ///< from a row to the next; a row may have bytes after its pixels
    bool isBigEndian = false;
    std::span<const std::uint8_t> data;
};

// Encodings rgb8, bgr8, 8UC3 (as bgr8), rgba8, bgra8, 8UC4 (as bgra8), mono8, 8UC1, mono16 (its upper byte),
// yuv422 (U first) and yuv422_yuy2. Error: badInput says what is wrong with the picture. Thread: any.

[[nodiscard]] core::Expected<core::ColourImage> colourOf(const RawPicture& picture);
/// Brightness by ITU-R BT.601, as OpenCV has it.
[[nodiscard]] core::Expected<core::GreyImage> greyOf(const RawPicture& picture);
/// Whether an encoding is one of the above and has colours.
[[nodiscard]] bool hasColours(std::string_view encoding);

// A JPEG or PNG picture. Error: badInput; unavailable, the decoder of OpenCV is not there. Thread: any.

[[nodiscard]] core::Expected<core::ColourImage> colourOfCoded(std::string_view bytes);
[[nodiscard]] core::Expected<core::GreyImage> greyOfCoded(std::string_view bytes);

} // namespace teleta::picture
