// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/dds/domain_config.h"

#include <optional>
#include <string>
#include <string_view>

namespace teleta::ros_arm {

/// A sensor of force and torque over ROS 2 as its TOML file describes it (kind = "ros_wrench").
struct RosWrenchFile {
    std::string name;
    std::string topic;      ///< geometry_msgs/msg/WrenchStamped
    std::string frame;      ///< link whose axes it has where its messages name none; empty: the arm's tip
    double sign = 1.0;      ///< -1: it tells what the arm exerts, not what acts on the arm
    double timeout_s = 0.1; ///< 0.02 .. 1; an older force is not known
    std::optional<dds::DomainConfig> domain; ///< nothing: the arm's
};

/// Error: notFound, ioFailed, badInput with file, line and column. Thread: any.
[[nodiscard]] core::Expected<RosWrenchFile> readRosWrench(const std::string& path);
/// The same of a text; file: named in errors.
[[nodiscard]] core::Expected<RosWrenchFile> parseRosWrench(std::string_view text, const std::string& file);

} // namespace teleta::ros_arm
