// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_servo/arm_servo.h"
#include "backend/core/error.h"
#include "backend/pipeline/arm_channel.h"

#include <cstdint>
#include <memory>

namespace teleta::arm_servo {

/// Servo tasks on an arm with a pad in the running system. Commands go to the arm as those of jogging do, so
/// its limits, its watchdog, the lease of a site and STOP hold at the robot's end as well. Thread: the
/// viewer's of the channel.
class ChannelServo {
public:
    /// arm: not null. Failure: badInput for an arm without a pad or a description of its joints, a recorded
    /// one, and a pad whose loads are not in N.
    [[nodiscard]] static core::Expected<std::unique_ptr<ChannelServo>>
    open(std::shared_ptr<pipeline::ArmChannel> arm);

    void setTask(ArmTask task, double force_N) { m_servo.setTask(task, force_N); }
    /// Something else moves the arm: the next press is a rehearsal.
    void forget() { m_servo.forget(); }
    /// Takes the newest of the arm and of its pad, whose snapshot the caller has updated, and posts what
    /// follows. At 20 Hz or more while the switch is held. held: the dead-man switch. stopped: STOP is
    /// engaged, or was since the last tick. jointsOld: the caller knows that the readings are.
    const ArmServoStep& tick(std::int64_t now_ns, bool held, bool stopped, bool jointsOld);

    [[nodiscard]] const ArmServo& servo() const { return m_servo; }
    [[nodiscard]] const ArmServoStep& newest() const { return m_step; }

private:
    ChannelServo(std::shared_ptr<pipeline::ArmChannel> arm, std::shared_ptr<const PadArm> pad);

    std::shared_ptr<pipeline::ArmChannel> m_arm;
    ArmServo m_servo;
    ArmServoStep m_step;
};

} // namespace teleta::arm_servo
