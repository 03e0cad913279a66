// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace teleta::cli {

struct ArmJogOptions {
    std::string path;    ///< of the arm's file, or of a site's
    std::string arm;     ///< at a site: its name there; empty: the only one
    std::string joint;   ///< its name in the URDF
    double rate = 0.0;   ///< rad/s, prismatic m/s; not 0
    double time_s = 0.0; ///< > 0
    bool yes = false;    ///< move without asking
    bool json = false;
};

/// Moves a joint of a real arm for a short time, as an operator would who holds the switch, and prints how
/// far it went and when it was at rest. Asks on a terminal; throws CLI::ValidationError elsewhere unless yes.
/// An interruption lets the switch go. Error: that of openJogTarget(); unavailable,
/// the arm cannot be moved now or was held by something else than the operator. Thread: one; it waits.
[[nodiscard]] core::Expected<void> jogArm(const ArmJogOptions& options);

} // namespace teleta::cli
