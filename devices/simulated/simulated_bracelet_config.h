// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_worker.h"

#include <array>
#include <cstdint>
#include <optional>
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

} // namespace teleta::simulated
