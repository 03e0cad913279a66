// SPDX-License-Identifier: GPL-3.0-or-later
// Over many motors, noise levels and seeds the results are correct within their own standard errors.
#include "backend/motors/motor_fit.h"
#include "tests/backend/motors/measured_motor.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

using namespace teleta;
using simulated::SimulatedMotor;

namespace {

SimulatedMotor randomMotor(std::mt19937_64& random) {
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    SimulatedMotor motor;
    do {
        motor = {.rise_s = between(0.008, 0.08),
                 .fall_s = between(0.008, 0.08),
                 .start = between(0.05, 0.6),
                 .fullSpeed_Hz = between(120.0, 350.0),
                 .bend = between(0.5, 1.3)};
        // A motor slower than 5 % of the full speed counts as standing still.
    } while (std::pow(motor.start, motor.bend) < 0.1);
    return motor;
}

} // namespace

TEST(MotorFitStability, staysWithinItsStandardErrorsOverMotorsAndNoise) {
    std::mt19937_64 random(20);
    for (const double noise_Hz : {0.1, 1.0, 4.0, 12.0}) {
        int fitted = 0;
        int riseWithin2 = 0;
        int fallWithin2 = 0;
        double squares = 0.0;
        double levels = 0.0;
        constexpr int kMotors = teleta::test::kSanitized ? 2 : 20;
        for (int k = 0; k < kMotors; ++k) {
            const SimulatedMotor motor = randomMotor(random);
            const auto fit = motors::fitMotor(test::measured(motor, noise_Hz, random()));
            ASSERT_TRUE(fit) << noise_Hz << ' ' << motor.start << ' ' << motor.bend << ' '
                             << core::describe(fit.error());
            ++fitted;
            EXPECT_LE(fit->startLow, motor.start);
            EXPECT_GE(fit->startHigh, motor.start);
            const double riseOff = (fit->profile.riseTime_s - test::rise90_s(motor)) / fit->riseError_s;
            const double fallOff = (fit->profile.fallTime_s - test::fall10_s(motor)) / fit->fallError_s;
            EXPECT_LT(std::abs(riseOff), 5.0);
            EXPECT_LT(std::abs(fallOff), 5.0);
            riseWithin2 += std::abs(riseOff) < 2.0 ? 1 : 0;
            fallWithin2 += std::abs(fallOff) < 2.0 ? 1 : 0;
            for (const motors::SpeedLevel& level : fit->levels) {
                const double off = (level.speed_Hz - test::truth_Hz(motor, level.drive)) / level.error_Hz;
                squares += off * off;
                levels += 1.0;
            }
            EXPECT_NEAR(fit->residual_Hz, noise_Hz, 0.1 * noise_Hz);
        }
        EXPECT_EQ(fitted, kMotors);
        if (teleta::test::kSanitized)
            continue;
        // 95 % of 20 are 19; fewer than 16 within two standard errors happen once in 10 000 times.
        EXPECT_GE(riseWithin2, 16) << noise_Hz;
        EXPECT_GE(fallWithin2, 16) << noise_Hz;
        EXPECT_NEAR(std::sqrt(squares / levels), 1.0, 0.25) << noise_Hz;
    }
}

TEST(MotorFitStability, findsSlowMotorsWithLongerStairs) {
    const SimulatedMotor slow{.rise_s = 0.3, .fall_s = 0.5, .start = 0.31, .fullSpeed_Hz = 180.0};
    const auto fit = motors::fitMotor(test::measured(slow, 2.0, 1, motors::stairsAndPulses(1.5)));
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_NEAR(fit->profile.riseTime_s, test::rise90_s(slow), 4.0 * fit->riseError_s);
    EXPECT_NEAR(fit->profile.fallTime_s, test::fall10_s(slow), 4.0 * fit->fallError_s);
}
