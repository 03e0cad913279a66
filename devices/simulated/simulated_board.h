// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/bracelet/bracelet_link.h"
#include "backend/core/bracelet/tactors.h"
#include "backend/core/random_stream.h"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <string>

namespace teleta::simulated {

/// What goes wrong with a simulated bracelet and its link, for tests and demonstrations.
struct BraceletFaults {
    bool unplugged = false;   ///< lost, and not found again until it is plugged in
    bool failWrites = false;  ///< every write fails, which counts as a loss; it can be opened again
    bool mute = false;        ///< takes frames and answers none
    double slowWrite_s = 0.0; ///< every write takes so long; 0 .. 10
    double dropShare = 0.0;   ///< share of the frames that the link loses although writing succeeds, 0 .. 1
    bool tooHot = false;      ///< its board says so, and does as it is told
    bool supplyLow = false;   ///< likewise
    bool refuse = false;      ///< its board understands no frame that drives a motor, and says so

    bool operator==(const BraceletFaults&) const = default;
};

/// How a motor turns: it stands below a drive, has a speed for every drive above it,
///   steady = fullSpeed_Hz drive^bend
/// and lags behind it: x' = (steady - x) / rise_s upwards, / fall_s downwards; > 0. Real motors have to be
/// measured; this model is an assumption, and calibration must recover its parameters.
struct SimulatedMotor {
    double rise_s = 0.024;
    double fall_s = 0.033;
    double start = 0.0; ///< share of the full drive
    double fullSpeed_Hz = 250.0;
    double bend = 1.0;
};
using SimulatedMotors = std::array<SimulatedMotor, core::kTactors>;

/// Six motors of one type with the usual spread: each starts, follows and saturates differently.
[[nodiscard]] inline SimulatedMotors unequalMotors() {
    return {
        SimulatedMotor{.rise_s = 0.024, .fall_s = 0.033, .start = 0.163, .fullSpeed_Hz = 250.0, .bend = 0.80},
        SimulatedMotor{.rise_s = 0.021, .fall_s = 0.030, .start = 0.188, .fullSpeed_Hz = 262.0, .bend = 0.85},
        SimulatedMotor{.rise_s = 0.028, .fall_s = 0.037, .start = 0.141, .fullSpeed_Hz = 241.0, .bend = 0.75},
        SimulatedMotor{.rise_s = 0.023, .fall_s = 0.031, .start = 0.212, .fullSpeed_Hz = 255.0, .bend = 0.90},
        SimulatedMotor{.rise_s = 0.026, .fall_s = 0.036, .start = 0.172, .fullSpeed_Hz = 236.0, .bend = 0.78},
        SimulatedMotor{
            .rise_s = 0.022, .fall_s = 0.029, .start = 0.155, .fullSpeed_Hz = 247.0, .bend = 0.83}};
}

struct SimulatedBraceletConfig {
    std::string name{}; ///< empty: "Simulated bracelet"
    /// Empty: motors that follow at once, from 0 on, and are not measured.
    std::optional<SimulatedMotors> motors = std::nullopt;
    double speedNoise_Hz = 0.0; ///< standard deviation of the speeds that it measures
    double maximumRate_Hz = 1000.0;
    BraceletFaults faults{};
    std::uint64_t faultSeed = 1; ///< which frames are dropped
    core::BraceletLinkConfig link{};
};

/// The board and motors of a simulated bracelet: accepts and answers frames and turns the motors off after
/// the timeout of the last frame. Stays powered while it is unplugged. Thread: any.
class SimulatedBoard {
public:
    explicit SimulatedBoard(const SimulatedBraceletConfig& config);

    /// False: the connection is lost.
    [[nodiscard]] bool take(std::uint16_t sequence, const core::Drive& drive, std::uint16_t timeout_ms);
    /// Fetches the next answer, of which a full queue keeps the oldest 64, as the kernel does.
    [[nodiscard]] bool answer(core::BoardReport& report);

    void setFaults(const BraceletFaults& faults);
    [[nodiscard]] BraceletFaults faults() const;

    /// What the motors are told now.
    [[nodiscard]] core::Drive drive();
    /// How strongly the motors turn now, 0 .. 1.
    [[nodiscard]] core::Intensities motors();
    /// What the motors' sensor tells; empty: there is none.
    [[nodiscard]] std::optional<core::MotorSpeeds> motorSpeeds();

private:
    void advance(std::int64_t now_ns);
    void turn(std::int64_t until_ns);

    std::shared_ptr<core::PacingClock> m_clock;
    std::optional<SimulatedMotors> m_kinds;
    double m_speedNoise_Hz;

    mutable std::mutex m_mutex; ///< of what follows
    std::condition_variable m_never;
    BraceletFaults m_faults;
    core::RandomStream m_dropRandom;
    std::mt19937_64 m_noiseRandom;
    std::normal_distribution<double> m_noise;
    std::deque<core::BoardReport> m_answers;
    core::Drive m_drive{};
    core::Intensities m_motors{};
    std::int64_t m_now_ns;           ///< the motors are those of this time
    std::int64_t m_timeoutAt_ns = 0; ///< of the last frame
    bool m_timedOut = false;         ///< since the frame before
};

} // namespace teleta::simulated
