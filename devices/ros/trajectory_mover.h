// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/motion_limits.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/trajectory_points.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/threads/mailbox.h"
#include "devices/ros/arm_fault.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace teleta::ros_arm {

/// What a mover knows at the time of a step.
struct MoverInput {
    std::int64_t now_ns = 0;       ///< steady, not decreasing
    bool stopped = false;          ///< STOP is engaged
    std::uint64_t engagements = 0; ///< of STOP, so that a short one is seen
    bool ready = false;            ///< the controller reads commands, and the graph is known
    bool lacking = false;          ///< a device that the arm requires is not live
    /// What the arm measures; nothing: its joints are not known, or too old.
    std::optional<arm_model::MotionReading> reading;
    std::optional<ArmFault> trouble; ///< what is wrong now
};

struct MoverState {
    core::ArmDrive drive = core::ArmDrive::held;
    std::uint32_t flags = 0;       ///< arm_model::MotionFlag: limits that act
    core::JointVector commanded;   ///< q_c, rad or m; empty before the arm was seen
    core::JointVector rate;        ///< with which q_c moves
    std::optional<ArmFault> fault; ///< until its cause is gone and the switch was let go
    bool needsRelease = true;      ///< the dead-man switch has to be let go before the arm moves
    bool ignoresPress = false;     ///< it is held, and has not been let go since the arm was held
};

/// Turns an operator's joint rates into commands for a trajectory controller, or into the rates in its
/// state(), one a step while the arm moves and none while it stands. Each command ends at rest, so that a
/// trajectory controller stops the arm by itself when no further one comes.
///   a rate other than 0   the dead-man switch is held; counts for ArmCommand::kJogLifetime_ns
///   a rate of 0           the switch was let go
/// After the start, STOP, a fault, joints that are not known, a controller that is gone, a step that is late,
/// a rise of the effort, or more than kLongestGap_ns of silence with the switch held, it must be seen let go
/// before the arm moves again. With STOP, without a
/// required device, or when the switch is let go, the arm brakes within its limits; with a fault and without
/// known joints nothing more is sent. Thread: post() from any; the rest from one.
class TrajectoryMover {
public:
    static constexpr std::int64_t kLongestGap_ns = 500'000'000;
    /// After a step that is later, the arm has come to rest by itself.
    static constexpr std::int64_t kLatestStep_ns = 100'000'000;
    /// The commanded position is kept so long after a motion, in which the arm still comes to it.
    static constexpr std::int64_t kSettling_ns = 500'000'000;

    /// period_ns: between steps. reaction_s: how long the arm goes on before it brakes when no further
    /// command comes.
    TrajectoryMover(std::shared_ptr<const arm_model::SerialChain> chain,
                    const arm_model::MotionLimits& limits, std::int64_t period_ns, double reaction_s);

    /// The latest command wins; one of the future counts as given now.
    void post(core::ArmCommand command, std::int64_t now_ns);

    /// One step, every period. What is to be sent; nothing: send nothing.
    [[nodiscard]] std::optional<std::array<arm_model::TrajectoryPoint, 2>> step(const MoverInput& input);

    [[nodiscard]] const MoverState& state() const { return m_state; }

private:
    static constexpr std::int64_t kNever_ns = std::numeric_limits<std::int64_t>::min();

    void takeCommand(const MoverInput& input);
    void block(std::int64_t now_ns);
    [[nodiscard]] bool released() const;
    [[nodiscard]] bool isPressed(std::int64_t now_ns) const;
    [[nodiscard]] bool active(std::int64_t now_ns) const;
    [[nodiscard]] bool mayMove(const MoverInput& input, bool late);
    [[nodiscard]] std::array<arm_model::TrajectoryPoint, 2> points(bool stopped) const;

    std::shared_ptr<const arm_model::SerialChain> m_chain;
    std::int64_t m_period_ns;
    arm_model::MotionGovernor m_governor;
    core::Mailbox<core::ArmCommand> m_commands;
    std::atomic<std::int64_t> m_released_ns{kNever_ns}; ///< when the switch was last let go
    MoverState m_state;
    std::optional<core::ArmCommand> m_command; ///< the newest with a rate other than 0
    std::int64_t m_blocked_ns = kNever_ns;     ///< a release must be newer
    std::int64_t m_lastStep_ns = kNever_ns;
    std::int64_t m_moved_ns = kNever_ns;
    std::uint64_t m_engagements = 0;
    bool m_moving = false; ///< the last command was not yet one of rest
};

} // namespace teleta::ros_arm
