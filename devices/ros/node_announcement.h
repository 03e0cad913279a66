// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/ros/files/ros_arm_file.h"

#include <memory>
#include <string>
#include <vector>

namespace teleta::ros_arm {

/// What a participant tells as its user data, so that ROS takes it for a program of its own.
inline constexpr const char* kEnclave = "enclave=/;";

/// Lets `ros2 node list` show this program as a node, as long as it lives. Nothing else depends on it.
/// Thread: one.
class NodeAnnouncement {
public:
    /// Tells the node /name with the ends that are its own. Error: as dds::AnyWriter::open().
    [[nodiscard]] static core::Expected<NodeAnnouncement>
    open(const std::shared_ptr<const dds::Participant>& participant, Distribution distribution,
         const std::string& name, const std::vector<dds::Guid>& readers,
         const std::vector<dds::Guid>& writers);

private:
    explicit NodeAnnouncement(dds::AnyWriter&& writer)
        : m_writer(std::move(writer)) {}

    dds::AnyWriter m_writer; ///< keeps the message for those who come later
};

} // namespace teleta::ros_arm
