// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_servo/channel_servo.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/arm_channel.h"

#include <QObject>

#include <cstdint>
#include <memory>

class QWidget;

namespace teleta::arm_servo {
class ArmServoPanel;
}

namespace teleta::console {

class JointViews;

/// Servo tasks on the arm that the Operate page shows: the panel below jogging, and the shadow of a rehearsal
/// in the 3-D view. There is a panel for an arm with a pad only. Jogging ends a task, and the other way
/// round. Thread: GUI.
class ArmServoViews : public QObject {
    Q_OBJECT

public:
    /// joints: lives longer; its jog dock gets the panel.
    ArmServoViews(core::StopSwitch& stop, JointViews& joints, QWidget* parent);

    /// Another arm; null: none. What runs on the previous one is ended.
    void setArm(const std::shared_ptr<pipeline::ArmChannel>& arm);
    /// Once a tick, after the newest of the arm and its pad were fetched.
    void tick();

    [[nodiscard]] arm_servo::ArmServoPanel& panel() { return *m_panel; }
    /// Null without an arm that can do tasks.
    [[nodiscard]] const arm_servo::ChannelServo* servo() const { return m_servo.get(); }

private:
    void step();

    core::StopSwitch& m_stop;
    JointViews& m_joints;
    arm_servo::ArmServoPanel* m_panel;
    std::shared_ptr<pipeline::ArmChannel> m_arm;
    std::unique_ptr<arm_servo::ChannelServo> m_servo;
    std::uint64_t m_engagements = 0; ///< of STOP, that a step has seen
};

} // namespace teleta::console
