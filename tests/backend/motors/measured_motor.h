// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"
#include "backend/motors/excitation.h"
#include "backend/motors/motor_recording.h"
#include "devices/simulated/simulated_board.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
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

/// Readings of the sensor of a simulated board for motor 3 during an excitation: a frame every 5 ms, a
/// reading every millisecond. The board knows its motor; the fit does not.
inline motors::MotorRecording measured(const simulated::SimulatedMotor& motor, double noise_Hz,
                                       std::uint64_t seed = 1,
                                       const motors::Excitation& excitation = motors::stairsAndPulses(),
                                       int samplePeriod_ms = 1) {
    constexpr std::size_t kTactor = 2;
    const auto clock = std::make_shared<SteppedClock>();
    simulated::SimulatedBraceletConfig config;
    config.motors = simulated::SimulatedMotors{};
    (*config.motors)[kTactor] = motor;
    config.speedNoise_Hz = noise_Hz;
    config.faultSeed = seed;
    config.link.clock = clock;
    simulated::SimulatedBoard board(config);
    motors::MotorRecording recording;
    std::uint16_t sequence = 0;
    for (int ms = 0; ms * 1e-3 < excitation.duration_s; ++ms, clock->add(1'000'000)) {
        if (ms % 5 == 0) {
            core::Drive drive{};
            drive[kTactor] = static_cast<std::uint16_t>(
                std::lround(excitation.driveAt(ms * 1e-3 + 1e-9) * core::kFullDrive));
            (void)board.take(++sequence, drive, 100);
        }
        if (ms % samplePeriod_ms != 0)
            continue;
        const auto reading = board.motorSpeeds();
        recording.time_s.push_back(ms * 1e-3);
        recording.drive.push_back(static_cast<double>(reading->drive[kTactor]) / core::kFullDrive);
        recording.speed_Hz.push_back(reading->speeds_Hz[kTactor]);
    }
    return recording;
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
