// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/mailbox.h"
#include "backend/simulation/camera/carrier_arm.h"

#include <cstdint>

namespace teleta::simulation {

/// What the arm that carries a tube says of itself.
struct CarrierState {
    TubePose pose;
    bool held = false;          ///< by STOP, or because nobody commands it any more
    std::uint64_t restarts = 0; ///< of the world
};

/// What the arm that carries a tube and whoever commands it tell each other. Thread: asked.take and state.set
/// by the camera's worker; asked.post and state.get from any.
struct CarrierLink {
    core::Mailbox<TubeVelocity> asked;
    core::LatestCopy<CarrierState> state;
};

} // namespace teleta::simulation
