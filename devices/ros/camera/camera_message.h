// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/colour_image.h"
#include "backend/core/error.h"
#include "backend/ros/messages.h"

namespace teleta::ros_camera {

// The picture in a message. Error: badInput says what is wrong with the message; unavailable, the decoder of
// OpenCV is not there. Thread: any.

/// In one of the encodings of picture::RawPicture.
[[nodiscard]] core::Expected<core::ColourImage> pictureOf(const ros::Image& message);
/// JPEG or PNG.
[[nodiscard]] core::Expected<core::ColourImage> pictureOf(const ros::CompressedImage& message);

} // namespace teleta::ros_camera
