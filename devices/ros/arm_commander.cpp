// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/arm_commander.h"

#include "backend/ros/topic_names.h"
#include "devices/ros/trajectory_message.h"
#include "devices/ros/wall_clock.h"

#include <cstdint>
#include <span>
#include <utility>

namespace teleta::ros_arm {

namespace {

/// The default of MoveIt Servo's incoming_command_timeout.
constexpr double kServoTimeout_s = 0.1;

ros::Time wallNow() {
    const std::int64_t now_ns = wallClock_ns();
    return {static_cast<std::int32_t>(now_ns / 1'000'000'000),
            static_cast<std::uint32_t>(now_ns % 1'000'000'000)};
}

/// Points for a trajectory controller, which begins at once.
class TrajectoryCommander : public ArmCommander {
public:
    TrajectoryCommander(dds::Writer<ros::JointTrajectory> writer, std::vector<std::string> names)
        : m_writer(std::move(writer))
        , m_message(std::move(names)) {}
    [[nodiscard]] bool send(const MotionCommand& command) override {
        return m_writer.write(m_message.fill(command.points));
    }
    [[nodiscard]] const dds::AnyWriter& writer() const override { return m_writer; }

private:
    dds::Writer<ros::JointTrajectory> m_writer;
    TrajectoryMessage m_message;
};

/// Rates for MoveIt Servo, which halts the arm by itself when no further one comes. It compares the stamps
/// with its own clock.
class ServoCommander : public ArmCommander {
public:
    ServoCommander(dds::Writer<ros::JointJog> writer, std::vector<std::string> names)
        : m_writer(std::move(writer))
        , m_names(std::move(names)) {
        for (std::string& name : m_names)
            m_pointers.push_back(name.data());
        m_message.header.frame_id = m_noFrame.data();
        ros::lend(m_message.joint_names, std::span(m_pointers));
    }
    [[nodiscard]] bool send(const MotionCommand& command) override {
        m_rate = command.rate;
        ros::lend(m_message.velocities, std::span(m_rate.data(), m_rate.size()));
        m_message.header.stamp = wallNow();
        return m_writer.write(m_message);
    }
    [[nodiscard]] const dds::AnyWriter& writer() const override { return m_writer; }

private:
    dds::Writer<ros::JointJog> m_writer;
    std::vector<std::string> m_names;
    std::vector<char*> m_pointers;
    core::JointVector m_rate;
    std::array<char, 1> m_noFrame{};
    ros::JointJog m_message{};
};

template <typename Commander, typename Message>
core::Expected<std::unique_ptr<ArmCommander>>
openAs(const std::shared_ptr<const dds::Participant>& participant, const RosArmFile& file,
       std::vector<std::string> names) {
    TELETA_TRY(auto writer, dds::Writer<Message>::open(participant, ros::ddsTopicOf(file.commandTopic()),
                                                       ros::kCommandWriter));
    return std::make_unique<Commander>(std::move(writer), std::move(names));
}

} // namespace

core::Expected<std::unique_ptr<ArmCommander>>
ArmCommander::open(const std::shared_ptr<const dds::Participant>& participant, const RosArmFile& file,
                   std::vector<std::string> names) {
    if (file.adapter == Adapter::moveitServo)
        return openAs<ServoCommander, ros::JointJog>(participant, file, std::move(names));
    return openAs<TrajectoryCommander, ros::JointTrajectory>(participant, file, std::move(names));
}

std::string_view commandTypeOf(Adapter adapter) {
    return adapter == Adapter::moveitServo ? "control_msgs/msg/JointJog"
                                           : "trajectory_msgs/msg/JointTrajectory";
}

double reactionOf_s(Adapter adapter) {
    return adapter == Adapter::moveitServo ? kServoTimeout_s : arm_model::kFirstPoint_s;
}

} // namespace teleta::ros_arm
