// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// Plays an array or a camera of a recording through the same processing as a device's frames.
[[nodiscard]] Command replayCommand();
/// Writes the streams of a recording as CSV files or an MCAP file.
[[nodiscard]] Command exportCommand();
/// Makes a recording of an MCAP file.
[[nodiscard]] Command importCommand();
/// Lists, shows, samples, converts, checks and plays patterns of the bracelet.
[[nodiscard]] Command patternCommand();
/// Lists connected devices, how fast they are, and why others cannot be used.
[[nodiscard]] Command devicesCommand();

} // namespace teleta::cli
