// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <teleta_ros_messages.h>

/// The messages of ROS 2 that the programs speak, as C structs that teleta_ros_messages.idl describes. In a
/// received message every text is a string that ends with 0; in one that is to be sent, every text must be
/// set ("" where there is nothing to say).
namespace teleta::ros {

using Time = ::builtin_interfaces_msg_dds__Time_;
using Duration = ::builtin_interfaces_msg_dds__Duration_;
using Header = ::std_msgs_msg_dds__Header_;
using CameraInfo = ::sensor_msgs_msg_dds__CameraInfo_;
using CompressedImage = ::sensor_msgs_msg_dds__CompressedImage_;
using Float64MultiArray = ::std_msgs_msg_dds__Float64MultiArray_;
using Image = ::sensor_msgs_msg_dds__Image_;
using JointJog = ::control_msgs_msg_dds__JointJog_;
using JointState = ::sensor_msgs_msg_dds__JointState_;
using JointTrajectory = ::trajectory_msgs_msg_dds__JointTrajectory_;
using JointTrajectoryPoint = ::trajectory_msgs_msg_dds__JointTrajectoryPoint_;
using String = ::std_msgs_msg_dds__String_;
using TactileState = ::tactile_msgs_msg_dds__TactileState_;
using TFMessage = ::tf2_msgs_msg_dds__TFMessage_;
using TwistStamped = ::geometry_msgs_msg_dds__TwistStamped_;
using WrenchStamped = ::geometry_msgs_msg_dds__WrenchStamped_;
/// Nodes of a participant, with gids as wide as those of Humble and of Iron and later.
using HumbleNodes = ::rmw_dds_common_humble_msg_dds__ParticipantEntitiesInfo_;
using JazzyNodes = ::rmw_dds_common_jazzy_msg_dds__ParticipantEntitiesInfo_;

// Between a site and its consoles.
using SiteInfo = ::teleta_msgs_msg_dds__SiteInfo_;
using SiteState = ::teleta_msgs_msg_dds__SiteState_;
using JointBlock = ::teleta_msgs_msg_dds__JointBlock_;
using TactileBlock = ::teleta_msgs_msg_dds__TactileBlock_;
using ImageFrame = ::teleta_msgs_msg_dds__ImageFrame_;
using SiteEvent = ::teleta_msgs_msg_dds__SiteEvent_;
using ConsolePresence = ::teleta_msgs_msg_dds__ConsolePresence_;
using ControlRequest = ::teleta_msgs_msg_dds__ControlRequest_;
using SiteArmCommand = ::teleta_msgs_msg_dds__ArmCommand_;
using ClockProbe = ::teleta_msgs_msg_dds__ClockProbe_;
using ClockAnswer = ::teleta_msgs_msg_dds__ClockAnswer_;
using ArmInfo = ::teleta_msgs_msg_dds__ArmInfo_;
using SiteStreamInfo = ::teleta_msgs_msg_dds__StreamInfo_;
using ArmState = ::teleta_msgs_msg_dds__ArmState_;
using RequestResult = ::teleta_msgs_msg_dds__RequestResult_;

/// A message that is published on a topic of its own.
struct MessageType {
    std::string_view name; ///< "sensor_msgs/msg/JointState"
    const dds_topic_descriptor_t* descriptor;
    /// The message in the words of its definition, see message_json.h. message: of this type.
    nlohmann::ordered_json (*json)(const void* message);
};

/// All messages that can be shown, in the order of their names. Thread: any (constant).
[[nodiscard]] std::span<const MessageType> messageTypes();

/// Null when the type is none of them. name: as MessageType::name.
[[nodiscard]] const MessageType* findMessageType(std::string_view name);

/// How Cyclone DDS describes a message. Thread: any (constant).
template <typename Message>
const dds_topic_descriptor_t& descriptorOf() = delete;
template <>
const dds_topic_descriptor_t& descriptorOf<CameraInfo>();
template <>
const dds_topic_descriptor_t& descriptorOf<CompressedImage>();
template <>
const dds_topic_descriptor_t& descriptorOf<Float64MultiArray>();
template <>
const dds_topic_descriptor_t& descriptorOf<Image>();
template <>
const dds_topic_descriptor_t& descriptorOf<JointJog>();
template <>
const dds_topic_descriptor_t& descriptorOf<JointState>();
template <>
const dds_topic_descriptor_t& descriptorOf<JointTrajectory>();
template <>
const dds_topic_descriptor_t& descriptorOf<String>();
template <>
const dds_topic_descriptor_t& descriptorOf<TactileState>();
template <>
const dds_topic_descriptor_t& descriptorOf<TFMessage>();
template <>
const dds_topic_descriptor_t& descriptorOf<TwistStamped>();
template <>
const dds_topic_descriptor_t& descriptorOf<WrenchStamped>();
/// Both are ParticipantEntitiesInfo of rmw_dds_common on the wire.
template <>
const dds_topic_descriptor_t& descriptorOf<HumbleNodes>();
template <>
const dds_topic_descriptor_t& descriptorOf<JazzyNodes>();
template <>
const dds_topic_descriptor_t& descriptorOf<SiteInfo>();
template <>
const dds_topic_descriptor_t& descriptorOf<SiteState>();
template <>
const dds_topic_descriptor_t& descriptorOf<JointBlock>();
template <>
const dds_topic_descriptor_t& descriptorOf<TactileBlock>();
template <>
const dds_topic_descriptor_t& descriptorOf<ImageFrame>();
template <>
const dds_topic_descriptor_t& descriptorOf<SiteEvent>();
template <>
const dds_topic_descriptor_t& descriptorOf<ConsolePresence>();
template <>
const dds_topic_descriptor_t& descriptorOf<ControlRequest>();
template <>
const dds_topic_descriptor_t& descriptorOf<SiteArmCommand>();
template <>
const dds_topic_descriptor_t& descriptorOf<ClockProbe>();
template <>
const dds_topic_descriptor_t& descriptorOf<ClockAnswer>();

/// A sequence of a message that is to be looked at.
template <typename Sequence>
[[nodiscard]] auto view(const Sequence& sequence) {
    return std::span(sequence._buffer, sequence._buffer == nullptr ? 0 : std::size_t{sequence._length});
}

/// Lets a sequence of a message that is to be sent name values that stay with the caller.
template <typename Sequence, typename Value, std::size_t kExtent>
void lend(Sequence& sequence, std::span<Value, kExtent> values) {
    sequence._buffer = values.data();
    sequence._length = static_cast<std::uint32_t>(values.size());
    sequence._maximum = sequence._length;
    sequence._release = false;
}

} // namespace teleta::ros
