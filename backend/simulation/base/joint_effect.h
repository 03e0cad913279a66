// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"

#include <functional>
#include <string_view>

namespace teleta::simulation {

/// What the encoders and torque sensors of an arm say.
struct JointReading {
    arm::JointVector angle_rad = arm::JointVector::Zero();
    arm::JointVector torque_Nm = arm::JointVector::Zero();
};

/// One imperfection of the joints' sensors, applied to each reading in turn. Thread: one.
struct JointEffect {
    std::string_view name;
    /// Angles of links and motors as they truly are; reading: changed in place.
    std::function<void(const arm::JointVector& trueLink_rad, const arm::JointVector& trueMotor_rad,
                       JointReading& reading)>
        apply{};
};

} // namespace teleta::simulation
