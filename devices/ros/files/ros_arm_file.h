// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/motion_limits.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "devices/dds/domain_config.h"
#include "devices/ros/files/ros_wrench_file.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::ros_arm {

/// What an arm's driver fills the field effort with.
enum class EffortUnit {
    newtonMetre, ///< Nm; prismatic: N
    ampere,      ///< current of the motors, which is shown and nothing else
    none,        ///< nothing that is used
};

/// What moves the arm at the robot.
enum class Adapter {
    trajectory,  ///< a trajectory controller
    moveitServo, ///< MoveIt Servo, with rates of the joints
    velocity,    ///< a controller that forwards rates and keeps the last one for ever
    position,    ///< a controller that forwards positions
};

/// What TOML files and sites call it: "moveit_servo".
[[nodiscard]] std::string_view nameOf(Adapter adapter);

/// Whether the robot ends a motion by itself when nothing more is sent.
[[nodiscard]] bool isGuarded(Adapter adapter);

/// How wide the names of readers and writers are when nodes are told.
enum class Distribution { jazzy, humble };

/// What an arm's touches are evaluated with (table [touch]).
struct RosTouchFile {
    /// Where its pad is, as far as the file says it: with array, link and pose are given.
    core::PadPlacement pad;
    std::string
        array; ///< path of the file that describes the pad; empty: a device of the site says its frame
};

/// An arm over ROS 2 as its TOML file describes it (kind = "ros_arm").
struct RosArmFile {
    std::string name;
    std::string description; ///< path of a URDF file; empty: the topic /robot_description
    std::string baseFrame;
    std::string tipFrame;
    std::string prefix; ///< put before every joint's name on the wire
    Adapter adapter = Adapter::trajectory;
    std::string controller;      ///< "/arm_controller", whose topic takes the commands
    std::string jointStates;     ///< topic
    double jointTimeout_s = 0.1; ///< 0.02 .. 1; older positions do not count
    EffortUnit effortUnit = EffortUnit::none;
    bool effortContainsGravity = false;  ///< with newtonMetre only
    std::vector<std::string> required;   ///< devices of a site without which the arm is held
    std::optional<RosWrenchFile> wrench; ///< the sensor for limits.forceStop_N; nothing: none
    std::optional<RosTouchFile> touch;
    std::string meshPath; ///< folder; empty: none
    dds::DomainConfig domain;
    Distribution distribution = Distribution::jazzy;
    bool announce = true;                                       ///< tell the node to other programs
    std::map<std::string, std::string, std::less<>> jointNames; ///< name in the URDF, name on the wire
    arm_model::MotionLimits limits;

    /// A joint's name in messages: as the file maps it, after the prefix.
    [[nodiscard]] std::string wireName(std::string_view joint) const;
    /// "/arm_controller/joint_trajectory", "/servo_node/delta_joint_cmds", "/velocity_controller/commands"
    [[nodiscard]] std::string commandTopic() const;
};

/// Relative paths of the file count from its folder. Error: notFound, ioFailed, badInput with file, line and
/// column. Thread: any.
[[nodiscard]] core::Expected<RosArmFile> readRosArm(const std::string& path);
/// The same of a text; file: named in errors.
[[nodiscard]] core::Expected<RosArmFile> parseRosArm(std::string_view text, const std::string& file);

} // namespace teleta::ros_arm
