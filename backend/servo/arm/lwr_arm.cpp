// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/lwr_arm.h"

#include <algorithm>

namespace teleta::servo {

core::JointVector jointVector(const LwrVector& q_rad) {
    core::JointVector joints = core::JointVector::zeros(kLwrJoints);
    std::copy_n(q_rad.data(), kLwrJoints, joints.begin());
    return joints;
}

SensorMotion LwrArm::carryOut(const core::JointVector& q_rad, const Twist& twist_Base) const {
    const LwrVector q = LwrVector::Map(q_rad.data());
    const JointMotion motion = solveRates(q, m_kinematics.forward(q).jacobian, twist_Base, m_inverse);
    return {.rate = jointVector(motion.rate_radPerS),
            .achieved = motion.achieved,
            .slowed = (motion.scale < 1.0),
            .atEnd = motion.atEnd.any(),
            .singular = (motion.damping > 0.0)};
}

} // namespace teleta::servo
