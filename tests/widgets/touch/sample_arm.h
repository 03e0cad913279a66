// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"

namespace teleta::test {

/// An arm with links of 0.3 m and 0.27 m and a program.
inline core::ArmDescription sampleArm() {
    core::ArmDescription arm;
    arm.name = "arm";
    arm.upperArmLength_m = 0.30;
    arm.forearmLength_m = 0.27;
    arm.halfThickness_m = 0.03;
    arm.lowest_rad = {-1.5, -1.0, -2.0, 0.0};
    arm.highest_rad = {1.5, 1.0, 2.0, 2.4};
    arm.fastest_radPerS = {1.0, 1.2, 1.4, 1.6};
    arm.hasProgram = true;
    return arm;
}

} // namespace teleta::test
