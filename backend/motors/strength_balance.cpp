// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/strength_balance.h"

#include <algorithm>
#include <cmath>

namespace teleta::motors {

namespace {

constexpr double kAboveStart = 0.01;

void setFullDrive(pattern::MotorProfile& motor, double full) {
    const double lowest = std::min(motor.startDrive + kAboveStart, 1.0);
    motor.fullDrive = std::clamp(full, lowest, 1.0);
    motor.rangeAssumed = false;
}

/// Drive that leads to this steady speed.
double driveAtSpeed(const pattern::MotorProfile& motor, double speed_Hz) {
    pattern::MotorProfile whole = motor;
    whole.fullDrive = 1.0;
    return driveOf(whole, std::max(intensityOfSpeed(whole, speed_Hz), 1e-12));
}

} // namespace

pattern::MotorProfiles balancedBySpeed(pattern::MotorProfiles motors) {
    double slowest_Hz = HUGE_VAL;
    for (const pattern::MotorProfile& motor : motors)
        if (!motor.assumed)
            slowest_Hz = std::min(slowest_Hz, motor.curve.back().speed_Hz);
    for (pattern::MotorProfile& motor : motors)
        if (!motor.assumed)
            setFullDrive(motor, driveAtSpeed(motor, slowest_Hz));
    return motors;
}

pattern::MotorProfiles balancedByFeel(pattern::MotorProfiles motors, const core::Intensities& equal) {
    const double most = *std::ranges::max_element(equal);
    for (std::size_t i = 0; i < motors.size(); ++i)
        setFullDrive(motors[i], equal[i] / most);
    return motors;
}

} // namespace teleta::motors
