// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/camera/camera_message.h"

#include "backend/picture/raw_picture.h"

#include <string_view>

namespace teleta::ros_camera {

core::Expected<core::ColourImage> pictureOf(const ros::Image& message) {
    return picture::colourOf({.encoding = message.encoding == nullptr ? "" : message.encoding,
                              .width_px = message.width,
                              .height_px = message.height,
                              .rowBytes = message.step,
                              .isBigEndian = message.is_bigendian != 0,
                              .data = ros::view(message.data)});
}

core::Expected<core::ColourImage> pictureOf(const ros::CompressedImage& message) {
    const auto data = ros::view(message.data);
    return picture::colourOfCoded({reinterpret_cast<const char*>(data.data()), data.size()});
}

} // namespace teleta::ros_camera
