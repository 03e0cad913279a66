// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"

#include <string_view>

namespace teleta::simulation {

/// What the encoders and torque sensors of an arm say.
struct JointReading {
    arm::JointVector angle_rad = arm::JointVector::Zero();
    arm::JointVector torque_Nm = arm::JointVector::Zero();
};

/// One imperfection of the joints' sensors, applied to each reading in turn. Thread: one.
class JointEffect {
public:
    explicit JointEffect(std::string_view name)
        : m_name(name) {}
    virtual ~JointEffect() = default;
    JointEffect(const JointEffect&) = delete;
    JointEffect& operator=(const JointEffect&) = delete;

    /// Angles of links and motors as they truly are; reading: changed in place.
    virtual void apply(const arm::JointVector& trueLink_rad, const arm::JointVector& trueMotor_rad,
                       JointReading& reading) = 0;
    /// Forgets all readings: the same readings then give the same result again.
    virtual void restart() {}

    [[nodiscard]] std::string_view name() const { return m_name; }

private:
    std::string_view m_name;
};

} // namespace teleta::simulation
