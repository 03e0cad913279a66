// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot_topics.h"

#include "messagesPubSubTypes.h"

namespace teleta::peer {

namespace dds = eprosima::fastdds::dds;

namespace {

constexpr EndQos kLatched{.reliable = true, .transientLocal = true, .depth = 1};

builtin_interfaces::msg::Time stampOf(std::int64_t ns) {
    builtin_interfaces::msg::Time stamp;
    stamp.sec(static_cast<std::int32_t>(ns / 1'000'000'000));
    stamp.nanosec(static_cast<std::uint32_t>(ns % 1'000'000'000));
    return stamp;
}

std_msgs::msg::Header headerOf(std::int64_t stamp_ns, const std::string& frame) {
    std_msgs::msg::Header header;
    header.stamp(stampOf(stamp_ns));
    header.frame_id(frame);
    return header;
}

geometry_msgs::msg::Vector3 vectorOf(double x, double y, double z) {
    geometry_msgs::msg::Vector3 vector;
    vector.x(x);
    vector.y(y);
    vector.z(z);
    return vector;
}

tf2_msgs::msg::TFMessage transformsOf(const std::vector<LinkFrame>& frames, std::int64_t stamp_ns) {
    tf2_msgs::msg::TFMessage message;
    for (const LinkFrame& frame : frames) {
        geometry_msgs::msg::TransformStamped one;
        one.header(headerOf(stamp_ns, frame.parent));
        one.child_frame_id(frame.child);
        one.transform().translation(vectorOf(frame.position_m[0], frame.position_m[1], frame.position_m[2]));
        one.transform().rotation().x(frame.rotation_xyzw[0]);
        one.transform().rotation().y(frame.rotation_xyzw[1]);
        one.transform().rotation().z(frame.rotation_xyzw[2]);
        one.transform().rotation().w(frame.rotation_xyzw[3]);
        message.transforms().push_back(one);
    }
    return message;
}

} // namespace

RobotTopics::RobotTopics(const RobotOptions& options, const std::string& urdf, const ArmPhysics& arm)
    : m_node(options.domain)
    , m_frame(arm.tip()) {
    dds::DataWriter* description =
        m_node.write("/robot_description", dds::TypeSupport(new std_msgs::msg::StringPubSubType), kLatched);
    std_msgs::msg::String text;
    text.data(urdf);
    description->write(&text);
    dds::DataWriter* fixed =
        m_node.write("/tf_static", dds::TypeSupport(new tf2_msgs::msg::TFMessagePubSubType), kLatched);
    tf2_msgs::msg::TFMessage transforms = transformsOf(arm.fixedFrames(), 0);
    fixed->write(&transforms);

    m_wrench =
        m_node.write("/ft/wrench", dds::TypeSupport(new geometry_msgs::msg::WrenchStampedPubSubType), {});
    if (options.frames)
        m_frames = m_node.write("/tf", dds::TypeSupport(new tf2_msgs::msg::TFMessagePubSubType), {});
    if (options.pad)
        m_pad = m_node.write("/pad/tactile", dds::TypeSupport(new std_msgs::msg::Float64MultiArrayPubSubType),
                             {});
    tellJointsAs(options.jointQos == "reliable");

    const EndQos command{.reliable = options.commandQos != "best-effort",
                         .transientLocal = options.commandQos == "transient-local",
                         .depth = 1};
    if (options.controller == "trajectory")
        m_node.read("/arm_controller/joint_trajectory",
                    dds::TypeSupport(new trajectory_msgs::msg::JointTrajectoryPubSubType), command,
                    &m_trajectories);
    else if (options.controller == "servo")
        m_node.read("/servo_node/delta_joint_cmds",
                    dds::TypeSupport(new control_msgs::msg::JointJogPubSubType), command, &m_jogs);
    else
        m_node.read("/" + options.controller + "_controller/commands",
                    dds::TypeSupport(new std_msgs::msg::Float64MultiArrayPubSubType), command, &m_values);
}

void RobotTopics::tellJointsAs(bool reliable) {
    if (m_joints != nullptr)
        m_node.remove(m_joints);
    m_joints = m_node.write("/joint_states", dds::TypeSupport(new sensor_msgs::msg::JointStatePubSubType),
                            {.reliable = reliable}, &m_jointReaders);
}

bool RobotTopics::tellJoints(const JointTelling& joints, std::int64_t stamp_ns) {
    sensor_msgs::msg::JointState message;
    message.header(headerOf(stamp_ns, ""));
    message.name(joints.name);
    message.position(joints.position_rad);
    message.velocity(joints.velocity_radPerS);
    message.effort(joints.effort_Nm);
    return m_joints->write(&message);
}

bool RobotTopics::tellWrench(const std::array<double, 6>& wrench, std::int64_t stamp_ns) {
    geometry_msgs::msg::WrenchStamped message;
    message.header(headerOf(stamp_ns, m_frame));
    message.wrench().force(vectorOf(wrench[0], wrench[1], wrench[2]));
    message.wrench().torque(vectorOf(wrench[3], wrench[4], wrench[5]));
    return m_wrench->write(&message);
}

bool RobotTopics::tellFrames(const std::vector<LinkFrame>& frames, std::int64_t stamp_ns) {
    if (m_frames == nullptr)
        return true;
    tf2_msgs::msg::TFMessage message = transformsOf(frames, stamp_ns);
    return m_frames->write(&message);
}

bool RobotTopics::tellPad(const std::vector<double>& taxels_N) {
    if (m_pad == nullptr)
        return true;
    std_msgs::msg::Float64MultiArray message;
    for (const auto& [label, size, stride] :
         {std::tuple("rows", ArmPhysics::kRows, ArmPhysics::kRows * ArmPhysics::kColumns),
          std::tuple("cols", ArmPhysics::kColumns, ArmPhysics::kColumns)}) {
        std_msgs::msg::MultiArrayDimension dimension;
        dimension.label(label);
        dimension.size(static_cast<std::uint32_t>(size));
        dimension.stride(static_cast<std::uint32_t>(stride));
        message.layout().dim().push_back(dimension);
    }
    message.data(taxels_N);
    return m_pad->write(&message);
}

} // namespace teleta::peer
