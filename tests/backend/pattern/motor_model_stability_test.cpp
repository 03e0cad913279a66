// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/motors/motor_model.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace teleta::pattern {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const MotorProfile kMotor = MotorProfile::assumedCoinMotor();

} // namespace

TEST(MotorModelStability, numbersThatAreNoneStandStill) {
    const teleta::test::WithoutFloatingPointTraps noNumbers;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double none : {nan, -kInfinity, -1.0, -0.0, 0.0}) {
        EXPECT_EQ(driveOf(kMotor, none), 0.0);
        EXPECT_EQ(steadySpeed_Hz(kMotor, none), 0.0);
        EXPECT_EQ(intensityOfSpeed(kMotor, none), 0.0);
    }
    for (const double much : {1.0, 2.0, 1e300, kInfinity}) {
        EXPECT_EQ(driveOf(kMotor, much), kMotor.fullDrive);
        EXPECT_EQ(intensityOfSpeed(kMotor, 250.0 * much), 1.0);
    }
    MotorModel model(kMotor);
    EXPECT_EQ(model.step(nan, 0.01), 0.0);
}

TEST(MotorModelStability, intensitiesComeBackOverTwelveDecades) {
    for (double intensity = 1e-12; intensity <= 1.0; intensity *= 10.0)
        EXPECT_NEAR(intensityOfSpeed(kMotor, steadySpeed_Hz(kMotor, driveOf(kMotor, intensity))), intensity,
                    8.0 * kEpsilon);
}

TEST(MotorModelStability, aStepOfAnyLengthIsTheClosedForm) {
    for (double step_s = 1e-12; step_s < 2e12; step_s *= 10.0) {
        MotorModel model(kMotor);
        const double speed_Hz = model.step(1.0, step_s);
        const double expected_Hz = -250.0 * std::expm1(-step_s * std::numbers::ln10 / kMotor.riseTime_s);
        EXPECT_NEAR(speed_Hz, expected_Hz, 4.0 * kEpsilon * 250.0) << step_s;
        EXPECT_LE(speed_Hz, 250.0);
    }
}

TEST(MotorModelStability, timesScaleOverTwentyFourDecades) {
    MotorModel plain(kMotor);
    for (int i = 0; i < 10; ++i)
        plain.step(i % 3 == 0 ? 0.0 : 0.8, 0.01);
    for (double factor = 1e-12; factor < 2e12; factor *= 10.0) {
        MotorProfile motor = kMotor;
        motor.riseTime_s *= factor;
        motor.fallTime_s *= factor;
        MotorModel scaled(motor);
        for (int i = 0; i < 10; ++i)
            scaled.step(i % 3 == 0 ? 0.0 : 0.8, 0.01 * factor);
        EXPECT_NEAR(scaled.speed_Hz(), plain.speed_Hz(), 1e-12) << factor;
    }
}

TEST(MotorModelStability, tenMillionStepsDoNotDriftFromThePeriodicSolution) {
    constexpr int kPeriods = 100'000;
    constexpr int kStepsPerHalf = 50;
    constexpr double kStep_s = 0.0005;
    MotorModel model(kMotor);
    double top_Hz = 0.0;
    double low_Hz = 0.0;
    for (int period = 0; period < kPeriods; ++period) {
        for (int i = 0; i < kStepsPerHalf; ++i)
            top_Hz = model.step(1.0, kStep_s);
        for (int i = 0; i < kStepsPerHalf; ++i)
            low_Hz = model.step(0.0, kStep_s);
    }
    const double half_s = kStepsPerHalf * kStep_s;
    const double up = std::exp(-half_s * std::numbers::ln10 / kMotor.riseTime_s);
    const double down = std::exp(-half_s * std::numbers::ln10 / kMotor.fallTime_s);
    const double expected_Hz = 250.0 * (1.0 - up) / (1.0 - up * down);
    EXPECT_NEAR(top_Hz, expected_Hz, 1e-10);
    EXPECT_NEAR(low_Hz, expected_Hz * down, 1e-10);
}

TEST(OverdriveStability, staysWithinItsBudgetForTenMillionSteps) {
    constexpr int kSteps = 10'000'000;
    constexpr double kStep_s = 0.001;
    MotorProfile motor = kMotor;
    motor.overdrive = 1.4;
    Overdrive overdrive(motor);
    int boosted = 0;
    for (int i = 0; i < kSteps; ++i)
        boosted += overdrive.step(i % 64 < 24 ? 0.9 : 0.0, kStep_s) > 1.0 ? 1 : 0;
    EXPECT_GT(boosted, 0);
    const double boosted_s = boosted * kStep_s;
    const double others_s = (kSteps - boosted) * kStep_s;
    EXPECT_LE(boosted_s, motor.longestOverdrive_s + 0.1 * others_s + 1e-6);
}

} // namespace teleta::pattern
