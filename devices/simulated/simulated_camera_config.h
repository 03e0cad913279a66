// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"
#include "devices/simulated/simulated_array_config.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace teleta::simulated {

struct SimulatedCameraConfig {
    std::size_t queueFrames = 8;
    SimulatedFaults faults{};
    double undecodableShare = 0.0; ///< share of the frames that arrive damaged, 0 .. 1; each is counted
    std::uint64_t faultSeed = 1;   ///< which frames are dropped or damaged
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::simulated
