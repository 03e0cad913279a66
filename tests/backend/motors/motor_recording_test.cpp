// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/motor_fit.h"
#include "backend/motors/motor_recording.h"
#include "backend/motors/speed_from_signal.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/motors/measured_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

using namespace teleta;
using motors::MotorRecording;
using motors::readMotorRecording;
using simulated::SimulatedMotor;

namespace {

const SimulatedMotor kMotor{
    .rise_s = 0.024, .fall_s = 0.033, .start = 0.22, .fullSpeed_Hz = 250.0, .bend = 0.7};

/// What an accelerometer on the motor picks up at 8 kHz: an eccentric mass that turns, its force with the
/// square of the speed, 1 at 250 Hz. The phase is the integral of the closed-form speed.
struct Signal {
    std::vector<double> time_s, drive, value;
};

Signal accelerometer(const motors::Excitation& excitation, double noise, double rate_Hz = 8000.0) {
    Signal signal;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.0, noise);
    double speed_Hz = 0.0;
    double phase = 0.0;
    for (int k = 0; k / rate_Hz < excitation.duration_s; ++k) {
        const double drive = excitation.driveAt(k / rate_Hz + 1e-9);
        signal.time_s.push_back(k / rate_Hz);
        signal.drive.push_back(drive);
        const double share = speed_Hz / 250.0;
        signal.value.push_back(0.02 + share * share * std::sin(phase) + normal(random));
        const double steady_Hz = drive >= kMotor.start ? test::truth_Hz(kMotor, drive) : 0.0;
        const double tau_s = steady_Hz > speed_Hz ? kMotor.rise_s : kMotor.fall_s;
        speed_Hz += (steady_Hz - speed_Hz) * -std::expm1(-1.0 / (rate_Hz * tau_s));
        phase += 2.0 * std::numbers::pi * speed_Hz / rate_Hz;
    }
    return signal;
}

std::string whyNot(const core::Expected<MotorRecording>& result) {
    return result ? std::string() : core::describe(result.error());
}

} // namespace

TEST(MotorRecording, isReadWithEveryDigitOfItsFile) {
    const test::TemporaryFolder folder;
    const MotorRecording recording = test::measured(kMotor, 1.0);
    const auto again = readMotorRecording(folder.write("r.csv", test::recordingText(recording)));
    ASSERT_TRUE(again) << whyNot(again);
    EXPECT_EQ(again->time_s, recording.time_s);
    EXPECT_EQ(again->drive, recording.drive);
    EXPECT_EQ(again->speed_Hz, recording.speed_Hz);
}

TEST(MotorRecording, thatIsWrongIsRefusedWithThePlace) {
    const test::TemporaryFolder folder;
    const auto read = [&](const char* text) {
        return whyNot(readMotorRecording(folder.write("r.csv", text)));
    };
    EXPECT_NE(read("time_s,commanded,speed_hz\n0,0,0\n0.1,0,nan\n").find("r.csv:3:7"), std::string::npos)
        << read("time_s,commanded,speed_hz\n0,0,0\n0.1,0,nan\n");
    EXPECT_NE(read("time_s,commanded,speed_hz\n0,0,0\n0,0,0\n").find("r.csv:3:1"), std::string::npos);
    EXPECT_NE(read("time_s,commanded,speed_hz\n0,0,0\n0.1,50,0\n").find("r.csv:3:5"), std::string::npos);
    EXPECT_NE(read("time_s,speed_hz\n0,0\n").find("commanded"), std::string::npos);
    EXPECT_NE(read("time_s,commanded,volume\n0,0,0\n").find("signal"), std::string::npos);
    EXPECT_NE(whyNot(readMotorRecording(folder.path("none.csv"))), "");
}

TEST(SpeedFromSignal, followsTheMotorThroughStairsAndPulses) {
    const motors::Excitation excitation = motors::stairsAndPulses();
    const Signal signal = accelerometer(excitation, 0.003);
    const auto recording = motors::speedFromSignal(signal.time_s, signal.drive, signal.value);
    ASSERT_TRUE(recording) << whyNot(recording);
    const auto fit = motors::fitMotor(*recording);
    ASSERT_TRUE(fit) << core::describe(fit.error());
    EXPECT_LE(fit->startLow, kMotor.start);
    EXPECT_GE(fit->startHigh, kMotor.start);
    // A turn lasts at least 4 ms, so lags of 24 and 33 ms are found to a few percent.
    EXPECT_NEAR(fit->profile.riseTime_s, test::rise90_s(kMotor), 0.05 * test::rise90_s(kMotor));
    EXPECT_NEAR(fit->profile.fallTime_s, test::fall10_s(kMotor), 0.15 * test::fall10_s(kMotor));
    for (const motors::SpeedLevel& level : fit->levels)
        EXPECT_NEAR(level.speed_Hz, test::truth_Hz(kMotor, level.drive), 1.0) << level.drive;
}

TEST(SpeedFromSignal, refusesWithTheReason) {
    const motors::Excitation excitation = motors::stairsAndPulses();
    const Signal good = accelerometer(excitation, 0.003);
    const auto refusal = [](const Signal& signal) {
        return whyNot(motors::speedFromSignal(signal.time_s, signal.drive, signal.value));
    };
    Signal signal = good;
    for (double& value : signal.value)
        value = std::clamp(value, -0.5, 0.5);
    EXPECT_NE(refusal(signal).find("clipped"), std::string::npos) << refusal(signal);

    signal = good;
    signal.drive.front() = 0.5;
    EXPECT_NE(refusal(signal).find("begin at rest"), std::string::npos) << refusal(signal);

    signal = accelerometer(excitation, 0.003);
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0.0, 0.1);
    for (double& value : signal.value)
        value = noise(random);
    EXPECT_NE(refusal(signal).find("no vibration"), std::string::npos) << refusal(signal);

    EXPECT_NE(refusal(accelerometer(excitation, 0.003, 1000.0)).find("too few"), std::string::npos)
        << refusal(accelerometer(excitation, 0.003, 1000.0));
}

TEST(SpeedFromSignal, comesFromAFileWithASignal) {
    const test::TemporaryFolder folder;
    const Signal signal = accelerometer(motors::stairsAndPulses(), 0.003);
    std::ostringstream text;
    text << "time_s,commanded,signal\n";
    text.precision(12);
    for (std::size_t i = 0; i < signal.time_s.size(); ++i)
        text << signal.time_s[i] << ',' << signal.drive[i] << ',' << signal.value[i] << '\n';
    const auto recording = readMotorRecording(folder.write("mic.csv", text.str()));
    ASSERT_TRUE(recording) << whyNot(recording);
    EXPECT_NEAR(*std::ranges::max_element(recording->speed_Hz), 250.0, 2.0);
}
