// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Names of ROS 2 and how DDS spells them. Thread: any (pure). Source: design.ros2.org, "Topic and Service
/// name mapping to DDS".
namespace teleta::ros {

/// "/arm/joint_states": parts of letters, digits and _, none beginning with a digit, each after a slash; at
/// most 253 bytes, so that the DDS name has at most 255.
[[nodiscard]] bool isTopicName(std::string_view name);

/// A part of such a name: what nodes, joints' prefixes and fields may be called.
[[nodiscard]] bool isNamePart(std::string_view part);

/// "rt/a/b" of "/a/b". topic: isTopicName().
[[nodiscard]] std::string ddsTopicOf(std::string_view topic);

/// The inverse; nothing for what is no topic of ROS: services (rq/, rr/), built-in topics, other programs'.
[[nodiscard]] std::optional<std::string> rosTopicOf(std::string_view ddsTopic);

/// "sensor_msgs::msg::dds_::JointState_" of "sensor_msgs/msg/JointState"; nothing for what has no such form.
[[nodiscard]] std::optional<std::string> ddsTypeOf(std::string_view type);

/// The inverse; a type that is not of ROS stays as it is.
[[nodiscard]] std::string rosTypeOf(std::string_view ddsType);

} // namespace teleta::ros
