// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// An array of a recording through the same processing as a device's frames, or a camera's pictures.
[[nodiscard]] Command replayCommand();
/// The streams of a recording as CSV files.
[[nodiscard]] Command exportCommand();
/// Lists, shows, samples, converts, checks and plays patterns of the bracelet.
[[nodiscard]] Command patternCommand();
/// What is connected, why not, and how fast.
[[nodiscard]] Command devicesCommand();

} // namespace teleta::cli
