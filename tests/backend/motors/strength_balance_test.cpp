// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/strength_balance.h"

#include <gtest/gtest.h>

using namespace teleta;
using pattern::MotorProfiles;

namespace {

MotorProfiles unequal() {
    MotorProfiles motors = pattern::assumedMotors();
    for (std::size_t i = 0; i < 5; ++i) {
        motors[i].assumed = motors[i].rangeAssumed = false;
        motors[i].startDrive = 0.2;
        motors[i].curve = {{0.0, 0.0}, {1.0, 200.0 + 10.0 * static_cast<double>(i)}};
    }
    return motors;
}

} // namespace

// Straight curves: speed 200 at 200 / full.
TEST(StrengthBalance, bySpeedSlowsAllMotorsDownToTheSlowest) {
    const MotorProfiles balanced = motors::balancedBySpeed(unequal());
    EXPECT_DOUBLE_EQ(balanced[0].fullDrive, 1.0);
    EXPECT_NEAR(balanced[4].fullDrive, 200.0 / 240.0, 1e-12);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(steadySpeed_Hz(balanced[i], driveOf(balanced[i], 1.0)), 200.0, 1e-9);
    EXPECT_EQ(balanced[5], pattern::MotorProfile::assumedCoinMotor()) << "nobody has measured it";
}

TEST(StrengthBalance, bySpeedOfUnmeasuredMotorsChangesNothing) {
    EXPECT_EQ(motors::balancedBySpeed(pattern::assumedMotors()), pattern::assumedMotors());
}

TEST(StrengthBalance, byFeelScalesToTheWeakestMotor) {
    const MotorProfiles balanced = motors::balancedByFeel(unequal(), {0.7, 0.6, 0.8, 0.7, 0.5, 0.1});
    EXPECT_DOUBLE_EQ(balanced[2].fullDrive, 1.0);
    EXPECT_DOUBLE_EQ(balanced[0].fullDrive, 0.7 / 0.8);
    EXPECT_DOUBLE_EQ(balanced[4].fullDrive, 0.5 / 0.8);
    EXPECT_DOUBLE_EQ(balanced[5].fullDrive, 1.0 / 3.0 + 0.01) << "just above its start";
    for (const pattern::MotorProfile& motor : balanced)
        EXPECT_TRUE(motor.valid());
}
