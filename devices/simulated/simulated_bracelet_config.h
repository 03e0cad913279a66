// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet_worker.h"

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

    bool operator==(const BraceletFaults&) const = default;
};

/// First-order lag of a motor: x' = (drive - x) / rise_s upwards, / fall_s downwards; > 0. The times of a
/// real motor have to be measured; these are an assumption.
struct MotorLag {
    double rise_s = 0.05;
    double fall_s = 0.08;
};

struct SimulatedBraceletConfig {
    std::string name{}; ///< empty: "Simulated bracelet"
    std::optional<MotorLag> lag = std::nullopt;
    double maximumRate_Hz = 1000.0;
    BraceletFaults faults{};
    std::uint64_t faultSeed = 1; ///< which frames are dropped
    core::BraceletLinkConfig link{};
};

} // namespace teleta::simulated
