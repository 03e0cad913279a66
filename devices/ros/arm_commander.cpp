// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/arm_commander.h"

#include "backend/ros/stamps.h"
#include "backend/ros/topic_names.h"
#include "devices/ros/trajectory_message.h"
#include "devices/ros/trajectory_mover.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace teleta::ros_arm {

namespace {

/// The default of MoveIt Servo's incoming_command_timeout.
constexpr double kServoTimeout_s = 0.1;

/// How often rest is told, so that the loss of a message does not matter.
constexpr int kRepeats = 20;

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
/// with its own clock: where that jumps back, the last rate would live on. So a pause begins with rates of
/// zero.
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
        m_restsToTell = kRepeats;
        return write(command.stamp_ns);
    }
    [[nodiscard]] bool pause(const MotionPause& pause) override {
        if (isDone())
            return true;
        --m_restsToTell;
        std::ranges::fill(m_rate, 0.0);
        return write(pause.stamp_ns);
    }
    [[nodiscard]] bool isDone() const override { return m_restsToTell == 0; }
    void forget() override { m_restsToTell = 0; }
    [[nodiscard]] const dds::AnyWriter& writer() const override { return m_writer; }

private:
    [[nodiscard]] bool write(std::int64_t stamp_ns) {
        ros::lend(m_message.velocities, std::span(m_rate.data(), m_rate.size()));
        m_message.header.stamp = ros::stampOf(stamp_ns);
        return m_writer.write(m_message);
    }

    dds::Writer<ros::JointJog> m_writer;
    std::vector<std::string> m_names;
    std::vector<char*> m_pointers;
    core::JointVector m_rate;
    int m_restsToTell = 0; ///< of the pause that begins or goes on
    std::array<char, 1> m_noFrame{};
    ros::JointJog m_message{};
};

/// Numbers for a controller that forwards them to the joints and keeps the last ones for ever: rates, or
/// positions. In a pause the rates fall to zero as with STOP, blindly. Rates are then zero as long as the
/// pause lasts; positions end where that braking ends, and the controller stays there. An arm that is blocked
/// is told to stay where it is.
class ForwardCommander : public ArmCommander {
public:
    ForwardCommander(dds::Writer<ros::Float64MultiArray> writer, const RosArmFile& file)
        : m_writer(std::move(writer))
        , m_sendsRates(file.adapter == Adapter::velocity)
        , m_deceleration(file.limits.stopDeceleration_radPerS2) {}

    [[nodiscard]] bool send(const MotionCommand& command) override {
        m_position = command.commanded;
        m_rate = command.rate;
        m_repeated = 0;
        m_paused = false;
        return write();
    }

    [[nodiscard]] bool pause(const MotionPause& pause) override {
        if (m_rate.empty())
            return true; // nothing was ever commanded
        m_paused = true;
        if (pause.blocked.size() == m_rate.size() && m_repeated == 0) {
            m_position = pause.blocked;
            halt();
        }
        if (!isAtRest()) {
            brake(pause.dt_s);
            return write();
        }
        // Whoever else commands the arm is not to be disturbed for ever.
        const bool goesOn = m_sendsRates && pause.alone;
        if (isDone() && !goesOn)
            return true;
        m_repeated = std::min(m_repeated + 1, kRepeats);
        return write();
    }

    [[nodiscard]] bool isBraking() const override { return m_paused && !isAtRest(); }
    [[nodiscard]] bool isDone() const override {
        return m_rate.empty() || (isAtRest() && m_repeated >= kRepeats);
    }
    void halt() override { std::ranges::fill(m_rate, 0.0); }
    void forget() override {
        m_rate = {};
        m_position = {};
    }
    [[nodiscard]] const dds::AnyWriter& writer() const override { return m_writer; }

private:
    [[nodiscard]] bool isAtRest() const {
        return std::ranges::all_of(m_rate, [](double rate) { return rate == 0.0; });
    }
    void brake(double dt_s) {
        for (std::size_t i = 0; i < m_rate.size(); ++i) {
            const double before = m_rate[i];
            m_rate[i] -= std::copysign(std::min(m_deceleration * dt_s, std::abs(before)), before);
            m_position[i] += 0.5 * (before + m_rate[i]) * dt_s;
        }
    }

    bool write() {
        core::JointVector& values = m_sendsRates ? m_rate : m_position;
        ros::lend(m_message.data, std::span(values.data(), values.size()));
        return m_writer.write(m_message);
    }

    dds::Writer<ros::Float64MultiArray> m_writer;
    bool m_sendsRates;
    double m_deceleration; ///< rad/s2 or m/s2
    core::JointVector m_position;
    core::JointVector m_rate; ///< empty: nothing was commanded yet
    bool m_paused = false;    ///< the last call was pause()
    int m_repeated = 0;       ///< commands since the arm is at rest, kRepeats at most
    ros::Float64MultiArray m_message{};
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
    if (file.adapter == Adapter::trajectory)
        return openAs<TrajectoryCommander, ros::JointTrajectory>(participant, file, std::move(names));
    TELETA_TRY(auto writer, dds::Writer<ros::Float64MultiArray>::open(
                                participant, ros::ddsTopicOf(file.commandTopic()), ros::kCommandWriter));
    return std::make_unique<ForwardCommander>(std::move(writer), file);
}

std::string_view commandTypeOf(Adapter adapter) {
    switch (adapter) {
    case Adapter::trajectory:
        return "trajectory_msgs/msg/JointTrajectory";
    case Adapter::moveitServo:
        return "control_msgs/msg/JointJog";
    case Adapter::velocity:
    case Adapter::position:
        break;
    }
    return "std_msgs/msg/Float64MultiArray";
}

AdapterTiming timingOf(Adapter adapter) {
    constexpr std::int64_t kPeriod_ns = 20'000'000;
    constexpr std::int64_t kForwardPeriod_ns = 10'000'000;
    switch (adapter) {
    case Adapter::trajectory:
        return {kPeriod_ns, arm_model::kFirstPoint_s};
    case Adapter::moveitServo:
        return {kPeriod_ns, kServoTimeout_s};
    case Adapter::velocity:
    case Adapter::position:
        break;
    }
    // What comes later than the latest step brings the arm to rest.
    return {kForwardPeriod_ns, 1e-9 * static_cast<double>(TrajectoryMover::kLatestStep_ns)};
}

} // namespace teleta::ros_arm
