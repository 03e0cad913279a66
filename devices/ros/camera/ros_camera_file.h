// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/dds/domain_config.h"

#include <string>
#include <string_view>

namespace teleta::ros_camera {

/// The message in which a camera sends its pictures.
enum class PictureFormat {
    image,           ///< sensor_msgs/msg/Image
    compressedImage, ///< sensor_msgs/msg/CompressedImage
};

/// A camera over ROS 2 that is looked at, as its TOML file describes it (kind = "ros_camera").
struct RosCameraFile {
    std::string name;
    std::string topic;
    PictureFormat format = PictureFormat::image; ///< otherwise by the end of the topic: "/compressed"
    double rate_Hz = 0.0;                        ///< pictures a second; 0: not known
    dds::DomainConfig domain;
};

/// Whether a file of this kind describes such a camera.
[[nodiscard]] bool isRosCameraKind(std::string_view kind);

/// Error: notFound, ioFailed, badInput with file, line and column. Thread: any.
[[nodiscard]] core::Expected<RosCameraFile> readRosCamera(const std::string& path);
/// The same of a text; file: named in errors.
[[nodiscard]] core::Expected<RosCameraFile> parseRosCamera(std::string_view text, const std::string& file);

} // namespace teleta::ros_camera
