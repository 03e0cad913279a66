// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_board.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulated {

namespace {

constexpr std::size_t kAnswersKept = 64;
constexpr double kSlowestWrite_s = 10.0;
constexpr double kSupply_V = 5.0;
constexpr double kLowSupply_V = 4.1;
constexpr double kTemperature_degC = 25.0;
constexpr double kTooHot_degC = 85.0;

} // namespace

SimulatedBoard::SimulatedBoard(const SimulatedBraceletConfig& config)
    : m_clock(config.link.clock)
    , m_kinds(config.motors)
    , m_speedNoise_Hz(config.speedNoise_Hz)
    , m_faults(config.faults)
    , m_dropRandom(config.faultSeed)
    , m_noiseRandom(config.faultSeed + 1)
    , m_now_ns(m_clock->now_ns()) {
}

bool SimulatedBoard::take(std::uint16_t sequence, const core::Drive& drive, std::uint16_t timeout_ms) {
    std::unique_lock lock(m_mutex);
    if (m_faults.slowWrite_s > 0.0) {
        const std::int64_t done_ns =
            m_clock->now_ns() +
            static_cast<std::int64_t>(std::min(m_faults.slowWrite_s, kSlowestWrite_s) * 1e9);
        while (m_clock->now_ns() < done_ns)
            m_clock->waitUntil(m_never, lock, done_ns);
    }
    if (m_faults.unplugged || m_faults.failWrites)
        return false;
    if (m_dropRandom.uniform() < m_faults.dropShare)
        return true;
    const std::int64_t now_ns = m_clock->now_ns();
    advance(now_ns);
    const bool refused = m_faults.refuse && !core::isOff(drive);
    if (!refused) {
        m_drive = drive;
        m_timeoutAt_ns = now_ns + std::int64_t{timeout_ms} * 1'000'000;
    }
    if (!m_faults.mute && m_answers.size() < kAnswersKept)
        m_answers.push_back({.sequence = sequence,
                             .driving = !core::isOff(m_drive),
                             .timedOut = m_timedOut,
                             .tooHot = m_faults.tooHot,
                             .supplyLow = m_faults.supplyLow,
                             .frameRefused = refused,
                             .supply_V = m_faults.supplyLow ? kLowSupply_V : kSupply_V,
                             .temperature_degC = m_faults.tooHot ? kTooHot_degC : kTemperature_degC});
    m_timedOut = false;
    return true;
}

bool SimulatedBoard::answer(core::BoardReport& report) {
    const std::scoped_lock lock(m_mutex);
    if (m_answers.empty())
        return false;
    report = m_answers.front();
    m_answers.pop_front();
    return true;
}

void SimulatedBoard::setFaults(const BraceletFaults& faults) {
    const std::scoped_lock lock(m_mutex);
    m_faults = faults;
}

BraceletFaults SimulatedBoard::faults() const {
    const std::scoped_lock lock(m_mutex);
    return m_faults;
}

core::Drive SimulatedBoard::drive() {
    const std::scoped_lock lock(m_mutex);
    advance(m_clock->now_ns());
    return m_drive;
}

core::Intensities SimulatedBoard::motors() {
    const std::scoped_lock lock(m_mutex);
    advance(m_clock->now_ns());
    return m_motors;
}

std::optional<core::MotorSpeeds> SimulatedBoard::motorSpeeds() {
    if (!m_kinds)
        return std::nullopt;
    const std::scoped_lock lock(m_mutex);
    core::MotorSpeeds speeds;
    speeds.time_ns = m_clock->now_ns();
    advance(speeds.time_ns);
    speeds.drive = m_drive;
    for (std::size_t i = 0; i < core::kTactors; ++i)
        speeds.speeds_Hz[i] =
            (*m_kinds)[i].fullSpeed_Hz * m_motors[i] + m_speedNoise_Hz * m_noise(m_noiseRandom);
    return speeds;
}

void SimulatedBoard::advance(std::int64_t now_ns) {
    if (!core::isOff(m_drive) && now_ns >= m_timeoutAt_ns) {
        turn(m_timeoutAt_ns);
        m_drive = {};
        m_timedOut = true;
    }
    turn(now_ns);
}

void SimulatedBoard::turn(std::int64_t until_ns) {
    const double step_s = static_cast<double>(until_ns - m_now_ns) * 1e-9;
    m_now_ns = until_ns;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const double drive = static_cast<double>(m_drive[i]) / core::kFullDrive;
        if (!m_kinds) {
            m_motors[i] = drive;
            continue;
        }
        const SimulatedMotor& kind = (*m_kinds)[i];
        const double target = drive > 0.0 && drive >= kind.start ? std::pow(drive, kind.bend) : 0.0;
        const double time_s = target > m_motors[i] ? kind.rise_s : kind.fall_s;
        m_motors[i] += (target - m_motors[i]) * -std::expm1(-step_s / time_s);
    }
}

} // namespace teleta::simulated
