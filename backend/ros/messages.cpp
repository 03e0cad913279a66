// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/messages.h"

#include "backend/ros/message_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace teleta::ros {

namespace {

template <typename Message>
MessageType type(std::string_view name) {
    return {name, &descriptorOf<Message>(),
            [](const void* message) { return messageJson(*static_cast<const Message*>(message)); }};
}

dds_topic_descriptor_t nodesOf(const dds_topic_descriptor_t& variant) {
    dds_topic_descriptor_t descriptor = variant;
    descriptor.m_typename = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
    return descriptor;
}

} // namespace

std::span<const MessageType> messageTypes() {
    static const std::array kTypes{
        type<JointJog>("control_msgs/msg/JointJog"),
        type<TwistStamped>("geometry_msgs/msg/TwistStamped"),
        type<WrenchStamped>("geometry_msgs/msg/WrenchStamped"),
        type<CameraInfo>("sensor_msgs/msg/CameraInfo"),
        type<CompressedImage>("sensor_msgs/msg/CompressedImage"),
        type<Image>("sensor_msgs/msg/Image"),
        type<JointState>("sensor_msgs/msg/JointState"),
        type<Float64MultiArray>("std_msgs/msg/Float64MultiArray"),
        type<String>("std_msgs/msg/String"),
        type<TactileState>("tactile_msgs/msg/TactileState"),
        type<TFMessage>("tf2_msgs/msg/TFMessage"),
        type<JointTrajectory>("trajectory_msgs/msg/JointTrajectory"),
    };
    return kTypes;
}

const MessageType* findMessageType(std::string_view name) {
    const std::span<const MessageType> types = messageTypes();
    const auto found = std::ranges::find(types, name, &MessageType::name);
    return found == types.end() ? nullptr : &*found;
}

template <>
const dds_topic_descriptor_t& descriptorOf<CameraInfo>() {
    return sensor_msgs_msg_dds__CameraInfo__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<CompressedImage>() {
    return sensor_msgs_msg_dds__CompressedImage__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<Float64MultiArray>() {
    return std_msgs_msg_dds__Float64MultiArray__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<Image>() {
    return sensor_msgs_msg_dds__Image__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<JointJog>() {
    return control_msgs_msg_dds__JointJog__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<JointState>() {
    return sensor_msgs_msg_dds__JointState__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<JointTrajectory>() {
    return trajectory_msgs_msg_dds__JointTrajectory__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<String>() {
    return std_msgs_msg_dds__String__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<TactileState>() {
    return tactile_msgs_msg_dds__TactileState__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<TFMessage>() {
    return tf2_msgs_msg_dds__TFMessage__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<TwistStamped>() {
    return geometry_msgs_msg_dds__TwistStamped__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<WrenchStamped>() {
    return geometry_msgs_msg_dds__WrenchStamped__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<HumbleNodes>() {
    static const dds_topic_descriptor_t descriptor =
        nodesOf(rmw_dds_common_humble_msg_dds__ParticipantEntitiesInfo__desc);
    return descriptor;
}
template <>
const dds_topic_descriptor_t& descriptorOf<JazzyNodes>() {
    static const dds_topic_descriptor_t descriptor =
        nodesOf(rmw_dds_common_jazzy_msg_dds__ParticipantEntitiesInfo__desc);
    return descriptor;
}
template <>
const dds_topic_descriptor_t& descriptorOf<SiteInfo>() {
    return teleta_msgs_msg_dds__SiteInfo__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<SiteState>() {
    return teleta_msgs_msg_dds__SiteState__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<JointBlock>() {
    return teleta_msgs_msg_dds__JointBlock__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<TactileBlock>() {
    return teleta_msgs_msg_dds__TactileBlock__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<ImageFrame>() {
    return teleta_msgs_msg_dds__ImageFrame__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<SiteEvent>() {
    return teleta_msgs_msg_dds__SiteEvent__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<ConsolePresence>() {
    return teleta_msgs_msg_dds__ConsolePresence__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<ControlRequest>() {
    return teleta_msgs_msg_dds__ControlRequest__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<SiteArmCommand>() {
    return teleta_msgs_msg_dds__ArmCommand__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<ClockProbe>() {
    return teleta_msgs_msg_dds__ClockProbe__desc;
}
template <>
const dds_topic_descriptor_t& descriptorOf<ClockAnswer>() {
    return teleta_msgs_msg_dds__ClockAnswer__desc;
}

} // namespace teleta::ros
