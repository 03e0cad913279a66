// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/message_json.h"

#include <nlohmann/json.hpp>

#include <type_traits>

namespace teleta::ros {

namespace {

using Json = nlohmann::ordered_json;

const char* text(const char* value) {
    return value == nullptr ? "" : value;
}

Json parts(const Time& value) {
    return {{"sec", value.sec}, {"nanosec", value.nanosec}};
}
Json parts(const Duration& value) {
    return {{"sec", value.sec}, {"nanosec", value.nanosec}};
}
Json parts(const Header& value) {
    return {{"stamp", parts(value.stamp)}, {"frame_id", text(value.frame_id)}};
}
Json parts(const ::geometry_msgs_msg_dds__Vector3_& value) {
    return {{"x", value.x}, {"y", value.y}, {"z", value.z}};
}
Json parts(const ::geometry_msgs_msg_dds__Quaternion_& value) {
    return {{"x", value.x}, {"y", value.y}, {"z", value.z}, {"w", value.w}};
}
Json parts(const ::geometry_msgs_msg_dds__TransformStamped_& value) {
    return {{"header", parts(value.header)},
            {"child_frame_id", text(value.child_frame_id)},
            {"transform",
             {{"translation", parts(value.transform.translation)},
              {"rotation", parts(value.transform.rotation)}}}};
}
Json parts(const ::std_msgs_msg_dds__MultiArrayDimension_& value) {
    return {{"label", text(value.label)}, {"size", value.size}, {"stride", value.stride}};
}

Json parts(const JointTrajectoryPoint& value);
Json parts(const ::sensor_msgs_msg_dds__ChannelFloat32_& value);

/// A sequence of numbers or of parts of a message.
template <typename Sequence>
Json list(const Sequence& sequence) {
    Json values = Json::array();
    for (const auto& value : view(sequence)) {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
            values.push_back(value);
        else
            values.push_back(parts(value));
    }
    return values;
}

template <typename Sequence>
Json texts(const Sequence& sequence) {
    Json values = Json::array();
    for (const char* value : view(sequence))
        values.push_back(text(value));
    return values;
}

Json parts(const JointTrajectoryPoint& value) {
    return {{"positions", list(value.positions)},
            {"velocities", list(value.velocities)},
            {"accelerations", list(value.accelerations)},
            {"effort", list(value.effort)},
            {"time_from_start", parts(value.time_from_start)}};
}
Json parts(const ::sensor_msgs_msg_dds__ChannelFloat32_& value) {
    return {{"name", text(value.name)}, {"values", list(value.values)}};
}

} // namespace

Json messageJson(const CameraInfo& message) {
    return {{"header", parts(message.header)},
            {"height", message.height},
            {"width", message.width},
            {"distortion_model", text(message.distortion_model)},
            {"d", list(message.d)},
            {"k", message.k},
            {"r", message.r},
            {"p", message.p},
            {"binning_x", message.binning_x},
            {"binning_y", message.binning_y},
            {"roi",
             {{"x_offset", message.roi.x_offset},
              {"y_offset", message.roi.y_offset},
              {"height", message.roi.height},
              {"width", message.roi.width},
              {"do_rectify", message.roi.do_rectify}}}};
}

Json messageJson(const CompressedImage& message) {
    return {{"header", parts(message.header)},
            {"format", text(message.format)},
            {"data_bytes", view(message.data).size()}};
}

Json messageJson(const Float64MultiArray& message) {
    return {{"layout", {{"dim", list(message.layout.dim)}, {"data_offset", message.layout.data_offset}}},
            {"data", list(message.data)}};
}

Json messageJson(const Image& message) {
    return {{"header", parts(message.header)},
            {"height", message.height},
            {"width", message.width},
            {"encoding", text(message.encoding)},
            {"is_bigendian", message.is_bigendian},
            {"step", message.step},
            {"data_bytes", view(message.data).size()}};
}

Json messageJson(const JointJog& message) {
    return {{"header", parts(message.header)},
            {"joint_names", texts(message.joint_names)},
            {"displacements", list(message.displacements)},
            {"velocities", list(message.velocities)},
            {"duration", message.duration}};
}

Json messageJson(const JointState& message) {
    return {{"header", parts(message.header)},
            {"name", texts(message.name)},
            {"position", list(message.position)},
            {"velocity", list(message.velocity)},
            {"effort", list(message.effort)}};
}

Json messageJson(const JointTrajectory& message) {
    return {{"header", parts(message.header)},
            {"joint_names", texts(message.joint_names)},
            {"points", list(message.points)}};
}

Json messageJson(const String& message) {
    return {{"data", text(message.data)}};
}

Json messageJson(const TactileState& message) {
    return {{"header", parts(message.header)}, {"sensors", list(message.sensors)}};
}

Json messageJson(const TFMessage& message) {
    return {{"transforms", list(message.transforms)}};
}

Json messageJson(const TwistStamped& message) {
    return {{"header", parts(message.header)},
            {"twist", {{"linear", parts(message.twist.linear)}, {"angular", parts(message.twist.angular)}}}};
}

Json messageJson(const WrenchStamped& message) {
    return {{"header", parts(message.header)},
            {"wrench", {{"force", parts(message.wrench.force)}, {"torque", parts(message.wrench.torque)}}}};
}

} // namespace teleta::ros
