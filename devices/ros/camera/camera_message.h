// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/colour_image.h"
#include "backend/core/error.h"
#include "backend/ros/messages.h"

#include <cstddef>

namespace teleta::ros_camera {

/// Pixels of a picture, at most: 8192 x 8192.
inline constexpr std::size_t kMostPixels = std::size_t{1} << 26U;

// The picture in a message. Error: badInput says what is wrong with the message; unavailable, the decoder of
// OpenCV is not there. Thread: any.

/// Encodings rgb8, bgr8, 8UC3 (as bgr8), rgba8, bgra8, 8UC4 (as bgra8), mono8, 8UC1, mono16 (its upper byte),
/// yuv422 (U first) and yuv422_yuy2. Rows may have bytes after their pixels.
[[nodiscard]] core::Expected<core::ColourImage> pictureOf(const ros::Image& message);
/// JPEG or PNG.
[[nodiscard]] core::Expected<core::ColourImage> pictureOf(const ros::CompressedImage& message);

} // namespace teleta::ros_camera
