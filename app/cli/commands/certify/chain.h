// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <string>

namespace teleta::cli {

/// The program into which faults are injected: its own process, made of the parts of a teleoperation.
///   simulated array -> processing -> live setpoints -> playback with its limits -> motor driver
///                   -> recording
/// It takes commands as lines on standard input: "go" follows the touches from now on, "stop" engages STOP,
/// "release" releases it. It says on standard output: "driving", "idle", "safe FRAMES" (frames that the
/// recording has on the disk), "recording failed".
struct ChainOptions {
    std::string driver;     ///< file that describes the driver of the motors
    std::uint16_t port = 0; ///< of this computer under which the driver is reached
    std::string recording;  ///< file that is made
};

/// Runs until it is interrupted. Then the motors are at zero and the recording is complete.
[[nodiscard]] core::Expected<void> runChain(const ChainOptions& options);

} // namespace teleta::cli
