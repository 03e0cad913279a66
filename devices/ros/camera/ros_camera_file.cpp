// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/camera/ros_camera_file.h"

#include "devices/ros/files/ros_file_keys.h"

namespace teleta::ros_camera {

namespace {

using core::NumberRange;
using core::TomlTable;

constexpr const char* kKind = "ros_camera";
constexpr std::string_view kCompressed = "/compressed";
constexpr double kHighestRate_Hz = 1000.0;

RosCameraFile read(core::TomlTable& root) {
    RosCameraFile file;
    (void)root.choice("kind", {kKind});
    file.name = root.text("name");
    file.topic = ros_arm::readTopic(root, "topic");
    if (root.has("format"))
        file.format = static_cast<PictureFormat>(root.choice("format", {"Image", "CompressedImage"}));
    else if (file.topic.ends_with(kCompressed))
        file.format = PictureFormat::compressedImage;
    file.rate_Hz = root.number("rate_Hz", NumberRange::between(0.0, kHighestRate_Hz), file.rate_Hz);
    file.domain = ros_arm::readRos(root).value_or(dds::DomainConfig());
    return file;
}

} // namespace

bool isRosCameraKind(std::string_view kind) {
    return kind == kKind;
}

core::Expected<RosCameraFile> readRosCamera(const std::string& path) {
    return ros_arm::readDocument(core::TomlDocument::open(path), read);
}

core::Expected<RosCameraFile> parseRosCamera(std::string_view text, const std::string& file) {
    return ros_arm::readDocument(core::TomlDocument::parse(text, file), read);
}

} // namespace teleta::ros_camera
