// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/arm/lwr_inverse.h"
#include "backend/servo/arm/servo_arm.h"

namespace teleta::servo {

/// The seven-joint arm of LwrKinematics as the servo controller sees it. Thread: any (const).
class LwrArm : public ServoArm {
public:
    /// kinematics: its tool is the sensor.
    explicit LwrArm(const LwrKinematics& kinematics, const InverseSettings& inverse = {})
        : m_kinematics(kinematics)
        , m_inverse(inverse) {}

    [[nodiscard]] std::size_t joints() const override { return kLwrJoints; }
    [[nodiscard]] SensorMotion carryOut(const core::JointVector& q_rad,
                                        const Twist& twist_Base) const override;

private:
    LwrKinematics m_kinematics;
    InverseSettings m_inverse;
};

[[nodiscard]] core::JointVector jointVector(const LwrVector& q_rad);

} // namespace teleta::servo
