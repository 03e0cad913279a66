// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/core/keys/toml_table.h"
#include "devices/dds/domain_config.h"

#include <optional>
#include <string>
#include <string_view>

namespace teleta::ros_arm {

// Keys that the files of all devices over ROS 2 have. Thread: any.

/// A topic; the fallback stands when the key is missing, without one the key is required.
[[nodiscard]] std::string readTopic(core::TomlTable& table, std::string_view key,
                                    const std::optional<std::string>& fallback = {});

/// Reads a file of which read() takes the keys; others that are there are errors. Error: the document's;
/// badInput, the first one in the order of reading.
template <typename File>
[[nodiscard]] core::Expected<File> readDocument(const core::Expected<core::TomlDocument>& document,
                                                File (*read)(core::TomlTable& root)) {
    if (!document)
        return core::Unexpected(document.error());
    core::TomlTable root = document->root();
    File file = read(root);
    root.finish();
    if (document->firstError())
        return core::Unexpected(*document->firstError());
    return file;
}

/// Where the other programs are, by the table [ros]; nothing without one.
[[nodiscard]] std::optional<dds::DomainConfig> readRos(core::TomlTable& root);

/// Of the table [ros]: `domain`, `interface` and `peers`.
[[nodiscard]] dds::DomainConfig readDomain(core::TomlTable& ros);

/// What a sensor tells is too old after this time: the key `timeout_s`, 0.02 to 1 s.
[[nodiscard]] double readTimeout_s(core::TomlTable& table, std::string_view key, double fallback_s);

/// The pose of a pad in the frame of its link: pose = [x, y, z, roll, pitch, yaw], m and rad; without it
/// both frames are one.
void readPose(core::TomlTable& table, core::PadPlacement& pad);

} // namespace teleta::ros_arm
