// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/error.h"
#include "devices/dds/domain_config.h"

#include <string>
#include <string_view>

namespace teleta::ros_array {

/// The message in which an array tells its taxels.
enum class ArrayFormat {
    tactileState,      ///< tactile_msgs/msg/TactileState
    float64MultiArray, ///< std_msgs/msg/Float64MultiArray
    image,             ///< sensor_msgs/msg/Image
};

/// A tactile array over ROS 2 as its TOML file describes it (kind = "ros_tactile").
struct RosArrayFile {
    std::string name;
    std::string topic;
    ArrayFormat format = ArrayFormat::float64MultiArray;
    std::string sensor; ///< of a TactileState: its name there; empty: the message has one sensor
    core::ArrayLayout layout;
    std::string unit = "N";
    double scale = 1.0;     ///< load units per number of the message
    double threshold = 0.2; ///< load from which a taxel counts as touched
    double rate_Hz = 0.0;   ///< messages a second; 0: not known
    dds::DomainConfig domain;
};

/// Whether a file of this kind describes such an array.
[[nodiscard]] bool isRosArrayKind(std::string_view kind);

/// Error: notFound, ioFailed, badInput with file, line and column. Thread: any.
[[nodiscard]] core::Expected<RosArrayFile> readRosArray(const std::string& path);
/// The same of a text; file: named in errors.
[[nodiscard]] core::Expected<RosArrayFile> parseRosArray(std::string_view text, const std::string& file);

} // namespace teleta::ros_array
