// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pattern/motors/motor_model.h"
#include "backend/pattern/motors/predicted_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace teleta::pattern;
using teleta::core::Intensities;

namespace {

/// 60 Hz at its start, half the voltage; 100 Hz at three quarters; 200 Hz at full.
MotorProfile bent() {
    MotorProfile profile;
    profile.name = "bent";
    profile.assumed = false;
    profile.startDrive = 0.5;
    profile.riseTime_s = 0.1;
    profile.fallTime_s = 0.2;
    profile.curve = {{0.5, 60.0}, {0.75, 100.0}, {1.0, 200.0}};
    profile.overdrive = 1.5;
    profile.longestOverdrive_s = 0.03;
    return profile;
}

} // namespace

TEST(MotorProfile, ofTheAssumedMotorIsMarkedAndGivesTheLevelsOfThePaper) {
    const MotorProfile profile = MotorProfile::assumedCoinMotor();
    EXPECT_TRUE(profile.assumed);
    EXPECT_TRUE(profile.valid());
    for (int level = 1; level <= 5; ++level)
        EXPECT_NEAR(steadySpeed_Hz(profile, driveOf(profile, levelIntensity(level))),
                    kLevelSpeeds_Hz[static_cast<std::size_t>(level - 1)], 0.5);
}

TEST(MotorProfile, startsAtTheStartVoltage) {
    const MotorProfile profile = bent();
    EXPECT_EQ(driveOf(profile, 0.0), 0.0);
    EXPECT_EQ(driveOf(profile, -1.0), 0.0);
    EXPECT_EQ(driveOf(profile, std::nan("")), 0.0);
    EXPECT_NEAR(driveOf(profile, 1e-12), 0.5, 1e-11);
    EXPECT_DOUBLE_EQ(driveOf(profile, 0.5), 0.75);
    EXPECT_EQ(driveOf(profile, 7.0), 1.0);
    EXPECT_EQ(steadySpeed_Hz(profile, 0.49), 0.0);
    EXPECT_EQ(steadySpeed_Hz(profile, std::nan("")), 0.0);
    EXPECT_DOUBLE_EQ(steadySpeed_Hz(profile, 0.5), 60.0);
    EXPECT_DOUBLE_EQ(steadySpeed_Hz(profile, 0.6), 76.0);
    EXPECT_DOUBLE_EQ(steadySpeed_Hz(profile, 0.9), 160.0);
    EXPECT_DOUBLE_EQ(steadySpeed_Hz(profile, 1.1), 240.0);
}

TEST(MotorProfile, speedAndIntensityAreInverse) {
    const MotorProfile profile = bent();
    for (const double intensity : {0.01, 0.3, 0.5, 0.77, 1.0})
        EXPECT_NEAR(intensityOfSpeed(profile, steadySpeed_Hz(profile, driveOf(profile, intensity))),
                    intensity, 1e-14);
    EXPECT_EQ(intensityOfSpeed(profile, 59.0), 0.0);
    EXPECT_EQ(intensityOfSpeed(profile, 1e9), 1.0);
    EXPECT_EQ(intensityOfSpeed(profile, std::nan("")), 0.0);
}

TEST(MotorProfile, withAFullDriveBelowOneEndsThere) {
    MotorProfile profile = bent();
    profile.fullDrive = 0.9;
    EXPECT_DOUBLE_EQ(driveOf(profile, 0.5), 0.7);
    EXPECT_DOUBLE_EQ(driveOf(profile, 1.0), 0.9);
    EXPECT_NEAR(intensityOfSpeed(profile, 160.0), 1.0, 1e-14);
    EXPECT_EQ(intensityOfSpeed(profile, 190.0), 1.0);
    EXPECT_NEAR(intensityOfSpeed(profile, steadySpeed_Hz(profile, driveOf(profile, 0.3))), 0.3, 1e-14);
}

TEST(MotorProfile, thatContradictsItselfIsNotValid) {
    const double inf = std::numeric_limits<double>::infinity();
    const auto broken = [](auto change) {
        MotorProfile profile = bent();
        change(profile);
        return !profile.valid();
    };
    EXPECT_TRUE(bent().valid());
    EXPECT_TRUE(broken([](MotorProfile& p) { p.startDrive = 0.0; }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.startDrive = std::nan(""); }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.fullDrive = 0.5; }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.fullDrive = 1.01; }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.startDrive = 0.4; })); // the curve begins at 0.5
    EXPECT_TRUE(broken([](MotorProfile& p) { p.riseTime_s = 0.0; }));
    EXPECT_TRUE(broken([&](MotorProfile& p) { p.fallTime_s = inf; }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.curve.clear(); }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.curve[1].speed_Hz = 60.0; }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.curve[2].drive = 0.9; }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.overdrive = 0.9; }));
    EXPECT_TRUE(broken([](MotorProfile& p) { p.longestOverdrive_s = -1.0; }));
}

TEST(MotorModel, risesTo90PercentInTheRiseTimeAndFallsTo10InTheFallTime) {
    MotorModel motor(bent());
    for (int k = 0; k < 10; ++k)
        motor.step(1.0, 0.01);
    EXPECT_NEAR(motor.speed_Hz(), 180.0, 1e-9);
    motor.step(1.0, 10.0);
    EXPECT_NEAR(motor.speed_Hz(), 200.0, 1e-9);
    EXPECT_NEAR(motor.step(0.0, 0.2), 20.0, 1e-9);
}

TEST(MotorModel, isTheSameWithManySmallStepsAsWithOne) {
    MotorModel one(bent());
    MotorModel many(bent());
    one.step(0.8, 0.05);
    for (int k = 0; k < 1'000'000; ++k)
        many.step(0.8, 0.05e-6);
    EXPECT_NEAR(many.speed_Hz(), one.speed_Hz(), 1e-8 * one.speed_Hz());
}

TEST(Overdrive, helpsTheMotorUpAndStaysInItsBounds) {
    const MotorProfile profile = bent();
    Overdrive overdrive(profile);
    double boosted_s = 0.0;
    for (int k = 0; k < 1000; ++k) {
        const double drive = overdrive.step(0.5, 0.001);
        EXPECT_TRUE(drive == profile.overdrive || drive == driveOf(profile, 0.5)) << drive;
        if (drive == profile.overdrive)
            boosted_s += 0.001;
    }
    // speed' towards 400 Hz: 90 % of 100 Hz after -0.1 / ln 10 ln(1 - 90/400) = 11.07 ms
    EXPECT_NEAR(boosted_s, 0.012, 1e-9);
    EXPECT_EQ(overdrive.step(0.0, 0.001), 0.0);
    EXPECT_EQ(overdrive.step(std::nan(""), 0.001), 0.0);
}

TEST(Overdrive, neverGivesMoreThanItsBudget) {
    const MotorProfile profile = bent();
    Overdrive overdrive(profile);
    double boosted_s = 0.0;
    for (int k = 0; k < 2000; ++k) {
        if (overdrive.step(k % 20 < 10 ? 1.0 : 0.0, 0.001) > 1.0)
            boosted_s += 0.001;
    }
    EXPECT_GT(boosted_s, profile.longestOverdrive_s);
    EXPECT_LE(boosted_s, profile.longestOverdrive_s + 0.1 * 2.0 + 1e-9);
}

TEST(Prediction, atAnyTimesFollowsTheLagAndRunsDown) {
    const MotorProfiles motors = assumedMotors();
    const MotorProfile& motor = motors[0];
    const double up_s = motor.riseTime_s / std::numbers::ln10;
    const double down_s = motor.fallTime_s / std::numbers::ln10;
    // On for 2 s; the last time is behind its end.
    const std::array<double, 5> times_s{0.0, 0.0, 0.0373, 1.9, 2.1};
    std::vector<double> predicted;
    forEachPredictedTime(*findBuiltIn("shape.F.static"), motors, times_s,
                         [&](std::size_t index, const Intensities& intensities) {
                             EXPECT_EQ(index, predicted.size());
                             EXPECT_EQ(intensities[1], 0.0);
                             predicted.push_back(intensities[0]);
                             return true;
                         });
    ASSERT_EQ(predicted.size(), times_s.size());
    for (std::size_t k = 0; k < times_s.size(); ++k) {
        const double share =
            times_s[k] <= 2.0 ? 1.0 - std::exp(-times_s[k] / up_s) : std::exp(-(times_s[k] - 2.0) / down_s);
        EXPECT_NEAR(predicted[k], std::max(0.0, (share * 3.0 - 1.0) / 2.0), 1e-9) << times_s[k];
    }
}

TEST(Prediction, ofAStepIsTheClosedFormOfTheLag) {
    MotorProfiles motors = assumedMotors();
    const MotorProfile& motor = motors[0];
    const double tau_s = motor.riseTime_s / std::numbers::ln10;
    int samples = 0;
    forEachPredictedSample(*findBuiltIn("shape.F.static"), motors, 200.0,
                           [&](double t_s, const Intensities& intensities, const Intensities& speeds_Hz) {
                               const double speed_Hz = 250.0 * (1.0 - std::exp(-t_s / tau_s));
                               EXPECT_NEAR(speeds_Hz[0], speed_Hz, 1e-9);
                               EXPECT_NEAR(intensities[0],
                                           std::max(0.0, (speed_Hz / 250.0 * 3.0 - 1.0) / 2.0), 1e-9);
                               EXPECT_EQ(speeds_Hz[1], 0.0);
                               ++samples;
                               return true;
                           });
    EXPECT_EQ(samples, 400);
}
