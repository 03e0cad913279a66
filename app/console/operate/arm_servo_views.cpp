// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/arm_servo_views.h"

#include "app/console/operate/joint_views.h"
#include "backend/core/steady_time.h"
#include "widgets/servo/arm/arm_servo_panel.h"

#include <utility>

namespace teleta::console {

ArmServoViews::ArmServoViews(core::StopSwitch& stop, JointViews& joints, QWidget* parent)
    : QObject(parent)
    , m_stop(stop)
    , m_joints(joints)
    , m_panel(new arm_servo::ArmServoPanel(parent)) {
    m_panel->hide();
    m_joints.putBelowJog(m_panel);
    connect(m_panel, &arm_servo::ArmServoPanel::heldChanged, this, [this](bool held) {
        if (held)
            m_joints.letGo();
        step(); // at once, that the arm is not told to go on until the next tick
    });
    connect(m_panel, &arm_servo::ArmServoPanel::taskChanged, this,
            [this](arm_servo::ArmTask task, double force_N) {
                if (m_servo)
                    m_servo->setTask(task, force_N);
                step();
            });
    connect(&m_joints, &JointViews::movesByHand, this, [this] {
        m_panel->letGo();
        if (m_servo)
            m_servo->forget();
        step();
    });
}

void ArmServoViews::setArm(const std::shared_ptr<pipeline::ArmChannel>& arm) {
    m_panel->letGo(); // while it is the arm that is moved
    m_servo.reset();
    m_arm = arm;
    const bool hasPad = m_arm && m_arm->chain() && m_arm->pad() && !m_arm->description().recorded;
    m_panel->setVisible(hasPad);
    m_joints.setShadow({});
    if (!hasPad)
        return;
    auto servo = arm_servo::ChannelServo::open(m_arm);
    m_panel->setRefusal(servo ? QString() : QString::fromStdString(core::describe(servo.error())));
    if (!servo)
        return;
    m_servo = std::move(*servo);
    m_servo->setTask(m_panel->task(), m_panel->force_N());
    m_engagements = m_stop.engagements();
    step();
}

void ArmServoViews::tick() {
    step();
}

void ArmServoViews::step() {
    if (!m_servo)
        return;
    // One that was engaged and released between two steps counts, too.
    const std::uint64_t engagements = m_stop.engagements();
    const bool wasEngaged = std::exchange(m_engagements, engagements) != engagements;
    const arm_servo::ArmServoStep& step = m_servo->tick(core::steadyNow_ns(), m_panel->isHeld(),
                                                        m_stop.engaged() || wasEngaged, m_joints.isSilent());
    m_joints.setShadow(step.shadow_rad.value_or(core::JointVector()));
    m_panel->setState(m_servo->servo(), step, QString::fromStdString(m_arm->device().hindrance()));
}

} // namespace teleta::console
