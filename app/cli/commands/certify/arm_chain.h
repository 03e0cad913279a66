// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace teleta::cli {

/// The program into which faults are injected, with an arm: an operator whose hand moves one joint to and
/// fro. Its commands and answers are those of runChain(), without a recording, "pause", which lets the
/// switch go, and "problem TEXT", what is in the way of a "go".
struct ArmChainOptions {
    std::string path;    ///< of the arm's file, or of a site's
    std::string device;  ///< at a site: the arm's name there; empty: the only one
    std::string joint;   ///< its name in the URDF
    double rate = 0.0;   ///< > 0; rad/s, prismatic m/s
    double centre = 0.0; ///< rad or m; the joint turns back kReach_s of motion away from it
};

inline constexpr double kReach_s = 0.5;

/// Runs until it is interrupted. Then the switch is let go. Error: that of openJogTarget(). Throws
/// CLI::ValidationError for an unknown joint.
[[nodiscard]] core::Expected<void> runArmChain(const ArmChainOptions& options);

} // namespace teleta::cli
