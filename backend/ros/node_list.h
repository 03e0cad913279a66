// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/messages.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::ros {

/// A node, as its program tells on the topic ros_discovery_info.
struct Node {
    std::string name; ///< with its namespace: "/arm/driver"
    std::size_t subscribers = 0;
    std::size_t publishers = 0;

    [[nodiscard]] bool operator==(const Node&) const = default;
};

/// The topic on which programs of ROS tell their nodes; it has no prefix.
inline constexpr const char* kNodesTopic = "ros_discovery_info";

/// Nodes of a program. Gids are 24 bytes in Humble and 16 from Iron on, under one name of the type: each
/// message is read as both. A Jazzy reader finds no nodes in a message of Humble, a Humble reader finds
/// nonsense in one of Jazzy or cannot read it. So nothing is returned unless there are nodes and the names of
/// all are names. Thread: any (pure).
[[nodiscard]] std::optional<std::vector<Node>> nodesOf(const HumbleNodes& message);
[[nodiscard]] std::optional<std::vector<Node>> nodesOf(const JazzyNodes& message);

} // namespace teleta::ros
