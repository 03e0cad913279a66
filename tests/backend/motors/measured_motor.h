// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"
#include "backend/motors/excitation.h"
#include "backend/motors/motor_recording.h"
#include "devices/simulated/simulated_board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

namespace teleta::test {

class SteppedClock : public core::PacingClock {
public:
    [[nodiscard]] std::int64_t now_ns() const override { return m_now_ns; }
    void add(std::int64_t step_ns) { m_now_ns += step_ns; }

private:
    std::int64_t m_now_ns = 1'000'000'000;
};

/// When the computer asks for a reading: delay_s is added to the next one.
using ReadingTimes = std::function<double(std::mt19937_64&)>;

/// Readings of the sensor of a simulated board for motor 3 during an excitation: a frame every 5 ms, readings
/// after each of the given times. The board knows its motor; the fit does not.
inline motors::MotorRecording measuredAt(const simulated::SimulatedMotor& motor, double noise_Hz,
                                         std::uint64_t seed, const motors::Excitation& excitation,
                                         const ReadingTimes& untilNext_s) {
    constexpr std::size_t kTactor = 2;
    constexpr std::int64_t kTick_ns = 100'000;
    const auto clock = std::make_shared<SteppedClock>();
    simulated::SimulatedBraceletConfig config;
    config.motors = simulated::SimulatedMotors{};
    (*config.motors)[kTactor] = motor;
    config.speedNoise_Hz = noise_Hz;
    config.faultSeed = seed;
    config.link.clock = clock;
    simulated::SimulatedBoard board(config);
    motors::MotorRecording recording;
    std::mt19937_64 random(seed);
    std::uint16_t sequence = 0;
    std::int64_t reading = 0;
    for (std::int64_t tick = 0;; ++tick, clock->add(kTick_ns)) {
        const double time_s = static_cast<double>(tick * kTick_ns) * 1e-9;
        if (time_s >= excitation.duration_s)
            return recording;
        if (tick % 50 == 0) {
            core::Drive drive{};
            drive[kTactor] =
                static_cast<std::uint16_t>(std::lround(excitation.driveAt(time_s + 1e-9) * core::kFullDrive));
            (void)board.take(++sequence, drive, 100);
        }
        if (tick < reading)
            continue;
        reading = tick + std::max<std::int64_t>(std::llround(untilNext_s(random) * 1e9 / kTick_ns), 1);
        const auto speeds = board.motorSpeeds();
        recording.time_s.push_back(time_s);
        recording.drive.push_back(static_cast<double>(speeds->drive[kTactor]) / core::kFullDrive);
        recording.speed_Hz.push_back(speeds->speeds_Hz[kTactor]);
    }
}

/// A reading every samplePeriod_ms.
inline motors::MotorRecording measured(const simulated::SimulatedMotor& motor, double noise_Hz,
                                       std::uint64_t seed = 1,
                                       const motors::Excitation& excitation = motors::stairsAndPulses(),
                                       int samplePeriod_ms = 1) {
    return measuredAt(motor, noise_Hz, seed, excitation,
                      [=](std::mt19937_64&) { return 1e-3 * samplePeriod_ms; });
}

/// A recording file as readMotorRecording() reads it.
inline std::string recordingText(const motors::MotorRecording& recording) {
    std::ostringstream text;
    text.precision(17);
    text << "time_s,commanded,speed_hz\n";
    for (std::size_t i = 0; i < recording.size(); ++i)
        text << recording.time_s[i] << ',' << recording.drive[i] << ',' << recording.speed_Hz[i] << '\n';
    return text.str();
}

/// Times to 90 % and to 10 % of first-order lags.
inline double rise90_s(const simulated::SimulatedMotor& motor) {
    return motor.rise_s * std::numbers::ln10;
}
inline double fall10_s(const simulated::SimulatedMotor& motor) {
    return motor.fall_s * std::numbers::ln10;
}

inline double truth_Hz(const simulated::SimulatedMotor& motor, double drive) {
    return motor.fullSpeed_Hz * std::pow(drive, motor.bend);
}

} // namespace teleta::test
