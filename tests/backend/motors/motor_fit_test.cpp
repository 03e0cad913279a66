// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/motor_fit.h"
#include "tests/backend/motors/measured_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace teleta;
using motors::Excitation;
using motors::fitMotor;
using motors::MotorRecording;
using simulated::SimulatedMotor;
using test::measured;

namespace {

const SimulatedMotor kMotor{
    .rise_s = 0.024, .fall_s = 0.033, .start = 0.163, .fullSpeed_Hz = 250.0, .bend = 0.8};

std::string refusal(const MotorRecording& recording) {
    const auto fit = fitMotor(recording);
    return fit ? std::string() : core::describe(fit.error());
}

Excitation steps(const std::vector<std::pair<double, double>>& drivesAndHolds) {
    Excitation excitation;
    for (const auto& [drive, hold_s] : drivesAndHolds) {
        excitation.steps.push_back({excitation.duration_s, drive});
        excitation.duration_s += hold_s;
    }
    return excitation;
}

MotorRecording changed(const auto& change) {
    MotorRecording recording = measured(kMotor, 0.5);
    change(recording);
    return recording;
}

} // namespace

// The motor of the board is different code from the model of the fit; its closed form is the truth.
TEST(MotorFit, findsStartLagAndCurveOfAMotorWithoutNoise) {
    const auto fit = fitMotor(measured(kMotor, 0.0));
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_LT(fit->startLow, kMotor.start);
    EXPECT_GT(fit->startHigh, kMotor.start);
    EXPECT_NEAR(fit->startHigh - fit->startLow, 0.025, 2.5e-4) << "one stair";
    EXPECT_NEAR(fit->profile.riseTime_s, test::rise90_s(kMotor), 1e-6);
    EXPECT_NEAR(fit->profile.fallTime_s, test::fall10_s(kMotor), 1e-6);
    ASSERT_GT(fit->levels.size(), 30U);
    for (const motors::SpeedLevel& level : fit->levels)
        EXPECT_NEAR(level.speed_Hz, test::truth_Hz(kMotor, level.drive), 1e-4) << level.drive;
    EXPECT_NEAR(fit->explained, 1.0, 1e-9);
    EXPECT_TRUE(fit->profile.valid());
    EXPECT_FALSE(fit->profile.assumed);
    EXPECT_FALSE(fit->profile.rangeAssumed);
    EXPECT_EQ(fit->predicted_Hz.size(), measured(kMotor, 0.0).size());
}

TEST(MotorFit, predictsWhatTheMotorDoesBetweenTheMeasuredDrives) {
    const auto fit = fitMotor(measured(kMotor, 1.0));
    ASSERT_TRUE(fit) << core::describe(fit.error());
    for (const double drive : {0.2, 0.33, 0.512, 0.77, 0.99})
        EXPECT_NEAR(steadySpeed_Hz(fit->profile, drive), test::truth_Hz(kMotor, drive), 1.0) << drive;
}

TEST(MotorFit, leavesOutAMotorThatGoesOnTurningBelowItsStart) {
    // Down the stairs the motor still turns at 0.1, where it would not start.
    const Excitation excitation = steps({{0, 0.3},
                                         {0.1, 0.3},
                                         {0.2, 0.3},
                                         {0.6, 0.3},
                                         {1, 0.3},
                                         {0.6, 0.3},
                                         {0.1, 0.3},
                                         {0, 0.3},
                                         {1, 0.3},
                                         {0, 0.3},
                                         {1, 0.3},
                                         {0, 0.3}});
    MotorRecording recording = measured(kMotor, 0.5, 1, excitation);
    for (std::size_t i = 0; i < recording.size(); ++i)
        if (recording.time_s[i] > 1.85 && recording.drive[i] > 0.05 && recording.drive[i] < 0.15)
            recording.speed_Hz[i] = 40.0;
    const auto fit = fitMotor(recording);
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_NEAR(fit->startLow, 0.1, 1e-3);
    EXPECT_NEAR(fit->startHigh, 0.2, 1e-3);
    EXPECT_NEAR(fit->profile.riseTime_s, test::rise90_s(kMotor), 0.002);
}

TEST(MotorFit, refusesWithTheReason) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(refusal({}).find("too short"), std::string::npos);
    EXPECT_NE(refusal(changed([&](auto& r) { r.speed_Hz[700] = nan; })).find("sample 701"),
              std::string::npos);
    EXPECT_NE(refusal(changed([](auto& r) { std::swap(r.time_s[10], r.time_s[11]); })).find("does not rise"),
              std::string::npos);
    EXPECT_NE(refusal(changed([](auto& r) { r.drive[5] = 1.2; })).find("1.2"), std::string::npos);
    EXPECT_NE(refusal(changed([](auto& r) { r.speed_Hz.pop_back(); })).find("speeds differ"),
              std::string::npos);
    EXPECT_NE(refusal(measured(kMotor, 0.5, 1, steps({{0.0, 1.0}}))).find("no step"), std::string::npos);
    EXPECT_NE(refusal(measured(kMotor, 0.5, 1, steps({{0, 0.3}, {0.5, 0.3}, {0.8, 0.3}, {0, 0.3}})))
                  .find("full drive was never"),
              std::string::npos);
    EXPECT_NE(
        refusal(measured(kMotor, 0.5, 1, steps({{0.5, 0.3}, {1, 0.3}, {0, 0.3}}))).find("begin at rest"),
        std::string::npos);
    EXPECT_NE(refusal(measured(kMotor, 0.5, 1, steps({{0, 0.3}, {1, 0.3}, {0, 0.3}}))).find("one level"),
              std::string::npos);
    EXPECT_NE(refusal(measured(kMotor, 0.5, 1, steps({{0, 0.3}, {0.5, 0.3}, {1, 0.3}}))).find("never falls"),
              std::string::npos);
    EXPECT_NE(refusal(measured(kMotor, 0.5, 1, steps({{0, 0.02}, {0.5, 0.02}, {1, 0.02}, {0, 0.02}})))
                  .find("too short"),
              std::string::npos);
    EXPECT_NE(refusal(changed([](auto& r) { std::ranges::fill(r.speed_Hz, 0.0); })).find("does not turn"),
              std::string::npos);
    EXPECT_NE(refusal(changed([](auto& r) {
                  for (double& s : r.speed_Hz)
                      s += 90.0;
              })).find("not 0"),
              std::string::npos);
}

TEST(MotorFit, tellsAClippedSensorFromASaturatedMotor) {
    const MotorRecording clipped = changed([](auto& r) {
        for (double& speed_Hz : r.speed_Hz)
            speed_Hz = std::min(speed_Hz, 200.0);
    });
    EXPECT_NE(refusal(clipped).find("clipped"), std::string::npos) << refusal(clipped);
    // The supply delivers at most 70 % of the drive; the sensor has noise.
    MotorRecording saturated = measured(kMotor, 0.0);
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise(0.0, 0.5);
    for (double& speed_Hz : saturated.speed_Hz)
        speed_Hz = std::min(speed_Hz, 190.0) + noise(random);
    EXPECT_NE(refusal(saturated).find("saturated"), std::string::npos) << refusal(saturated);
}

TEST(MotorFit, refusesAMotorThatSticksNowAndThen) {
    MotorRecording recording = measured(kMotor, 0.5);
    // The motor stands still during the stairs from 0.5 to 0.55.
    for (std::size_t i = 0; i < recording.size(); ++i)
        if (recording.drive[i] > 0.49 && recording.drive[i] < 0.56)
            recording.speed_Hz[i] = 0.0;
    EXPECT_NE(refusal(recording).find("but stood still at"), std::string::npos) << refusal(recording);
}

TEST(MotorFit, refusesATooCoarseRecordingOfTheLag) {
    // A reading every 0.2 s tells the levels but not what happens between them.
    const std::string why = refusal(
        measured({.rise_s = 0.01, .fall_s = 0.01, .start = 0.2}, 3.0, 1, motors::stairsAndPulses(2.0), 200));
    EXPECT_NE(why.find("determine"), std::string::npos) << why;
    EXPECT_NE(why.find("more samples per second"), std::string::npos) << why;
}

TEST(MotorFit, refusesWhatIsNoLag) {
    MotorRecording recording = measured(kMotor, 0.5);
    // The drive of another time: log and sensor data do not belong together.
    std::ranges::rotate(recording.speed_Hz, recording.speed_Hz.begin() + 150);
    const std::string why = refusal(recording);
    EXPECT_FALSE(why.empty());
}

// Readings come 1 ms apart at any phase of the frames, and late now and then; the motor differs from step to
// step by nothing.
TEST(MotorFit, agreesWithItsErrorsOnABusyComputer) {
    constexpr int kRepeats = 40;
    int riseHeld = 0;
    int fallHeld = 0;
    for (int seed = 1; seed <= kRepeats; ++seed) {
        const auto late = [](std::mt19937_64& random) {
            std::uniform_real_distribution<double> share(0.0, 1.0);
            return share(random) < 0.03 ? 1e-3 + 25e-3 * share(random) : 1e-3 * (0.9 + 0.2 * share(random));
        };
        const auto fit = fitMotor(
            test::measuredAt(kMotor, 0.5, static_cast<std::uint64_t>(seed), motors::stairsAndPulses(), late));
        ASSERT_TRUE(fit) << core::describe(fit.error());
        EXPECT_GT(fit->gapShare, 0.1);
        riseHeld += std::abs(fit->profile.riseTime_s - test::rise90_s(kMotor)) < 1.96 * fit->riseError_s;
        fallHeld += std::abs(fit->profile.fallTime_s - test::fall10_s(kMotor)) < 1.96 * fit->fallError_s;
    }
    EXPECT_GE(riseHeld, 36) << "of " << kRepeats << ", 90 %";
    EXPECT_GE(fallHeld, 36) << "of " << kRepeats << ", 90 %";
    EXPECT_LT(fitMotor(measured(kMotor, 0.5))->gapShare, 1e-9);
}
