// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"
#include "devices/simulated/simulated_array_config.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace teleta::simulated {

struct SimulatedArmConfig {
    std::size_t queueSamples = 8192; ///< of the joints
    std::size_t queueBlocks = 512;   ///< of the skin
    /// The consumer is woken when so much time of samples has come together.
    double batch_s = 0.005;
    /// Age of the newest sample from which joints and skin are stale; by default core::staleAfter_ns of the
    /// rate of each.
    std::optional<double> staleAfter_s = std::nullopt;
    /// A worker that is later than this does not catch up: the simulated world then stood still meanwhile.
    double longestCatchUp_s = 1.0;
    bool startProgram = true;    ///< the program runs from the start, if there is one
    SimulatedFaults faults{};    ///< of the link, for joints and skin alike
    std::uint64_t faultSeed = 1; ///< which samples and frames are dropped
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::simulated
