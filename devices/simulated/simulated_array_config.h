// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/scene_control.h"
#include "backend/core/threads/pacing_clock.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace teleta::simulated {

/// What goes wrong with a simulated device and its link, for tests and demonstrations.
struct SimulatedFaults {
    double lag_s = 0.0;     ///< frames come so much later; 0 .. 3600
    double dropShare = 0.0; ///< share of the frames that the link loses, 0 .. 1; each is counted
    bool silent = false;    ///< connected, but no frame comes
    bool unplugged = false; ///< lost, with attempts to connect again until it is plugged in

    bool operator==(const SimulatedFaults&) const = default;
};

struct SimulatedArrayConfig {
    std::size_t queueBlocks = 256;
    /// Age of the newest frame from which the data is stale; by default core::staleAfter_ns of the frame
    /// rate.
    std::optional<double> staleAfter_s = std::nullopt;
    /// A worker that is later than this does not catch up: the simulated world then stood still meanwhile.
    double longestCatchUp_s = 1.0;
    SimulatedFaults faults{};
    std::uint64_t faultSeed = 1; ///< which frames are dropped
    /// Null: nobody holds or restarts it, and after STOP it goes on.
    std::shared_ptr<core::SceneControl> scene = nullptr;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

} // namespace teleta::simulated
