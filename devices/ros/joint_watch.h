// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/joint_state_joiner.h"
#include "devices/ros/arm_fault.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::ros_arm {

/// The joint states of an arm, and whether they can be believed. Thread: one.
class JointWatch {
public:
    /// A joint that moves farther within kJumpTime_ns has jumped: 10 rad/s or m/s, which no arm reaches.
    static constexpr double kJump = 0.1; ///< rad or m
    static constexpr std::int64_t kJumpTime_ns = 10'000'000;

    /// names: of the joints on the wire, in the arm's order, as JointStateJoiner has them. topic: named in
    /// faults.
    JointWatch(std::vector<std::string> names, std::string topic, double timeout_s);

    /// Takes a message that was read at this steady time. The sample that it completes, if any; one with a
    /// jump is handed over as well.
    std::optional<ros::JoinedJoints> take(const ros::JointState& message, std::int64_t read_ns);

    /// What was wrong since the last call; the first thing counts.
    [[nodiscard]] std::optional<ArmFault> takeFault();

    /// The newest sample; nothing when some joint is missing or too old.
    [[nodiscard]] std::optional<ros::JoinedJoints> sampleAt(std::int64_t now_ns) const;
    /// Names of the joints that are missing or too old.
    [[nodiscard]] std::vector<std::string> missing(std::int64_t now_ns) const;

    [[nodiscard]] const ros::JointStateJoiner& joiner() const { return m_joiner; }
    [[nodiscard]] ros::JointStateJoiner& joiner() { return m_joiner; }

private:
    void compare(const ros::JoinedJoints& sample, std::int64_t read_ns);
    void note(ArmFaultKind kind, const std::string& what);

    std::vector<std::string> m_names;
    std::string m_topic;
    double m_timeout_s;
    ros::JointStateJoiner m_joiner;
    std::optional<ros::JoinedJoints> m_last;
    std::int64_t m_last_ns = 0;
    std::optional<ArmFault> m_fault;
};

} // namespace teleta::ros_arm
