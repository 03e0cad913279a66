// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/bracelet/tactors.h"
#include "devices/simulated/simulated_bracelet_config.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <random>

namespace teleta::simulated {

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
    std::mt19937_64 m_dropRandom;
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
