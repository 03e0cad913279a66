// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/trajectory_points.h"
#include "backend/core/device/joint_vector.h"
#include "backend/core/error.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/ros/files/ros_arm_file.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::ros_arm {

/// A command as the mover makes it: where the arm goes and how it comes to rest, and how fast it is now.
struct MotionCommand {
    std::array<arm_model::TrajectoryPoint, 2> points;
    core::JointVector commanded; ///< q_c, rad or m
    core::JointVector rate;      ///< with which q_c moves, rad/s or m/s
    std::int64_t stamp_ns = 0;   ///< wall clock, by the look that found it in agreement with the robot's
};

/// What is known where no motion is commanded.
struct MotionPause {
    double dt_s = 0.0;         ///< since the last command
    std::int64_t stamp_ns = 0; ///< as MotionCommand has it
    bool alone = true;         ///< nobody else commands the arm
    /// Where an arm stands that does not follow; empty: it follows, or its joints are not known.
    core::JointVector blocked{};
};

/// Sends an arm's commands in the way of its file's adapter. Thread: one.
class ArmCommander {
public:
    virtual ~ArmCommander() = default;
    /// names: of the joints on the wire. Error: as dds::AnyWriter::open().
    [[nodiscard]] static core::Expected<std::unique_ptr<ArmCommander>>
    open(const std::shared_ptr<const dds::Participant>& participant, const RosArmFile& file,
         std::vector<std::string> names);

    /// False: not sent in time.
    [[nodiscard]] virtual bool send(const MotionCommand& command) = 0;
    /// Instead of send(), when no motion is commanded for whatever reason: brings an arm to rest that nothing
    /// at the robot stops, and keeps it there. False: not sent in time.
    [[nodiscard]] virtual bool pause(const MotionPause& /*pause*/) { return true; }
    /// pause() brings the arm to rest now, and it is not there yet.
    [[nodiscard]] virtual bool isBraking() const { return false; }
    /// It is at rest, and was told so often enough that the loss of a message does not matter.
    [[nodiscard]] virtual bool isDone() const { return true; }
    /// Ends braking: the next pause() commands rest.
    virtual void halt() {}
    /// Nothing was commanded yet.
    virtual void forget() {}
    [[nodiscard]] virtual const dds::AnyWriter& writer() const = 0;
};

/// The type of an adapter's commands: "trajectory_msgs/msg/JointTrajectory".
[[nodiscard]] std::string_view commandTypeOf(Adapter adapter);

/// How an adapter's commands are timed.
struct AdapterTiming {
    std::int64_t period_ns = 0; ///< of the commands while the arm moves
    /// How long an arm goes on at the same rate when no further command comes, before it brakes.
    double reaction_s = 0.0;
};
[[nodiscard]] AdapterTiming timingOf(Adapter adapter);

} // namespace teleta::ros_arm
