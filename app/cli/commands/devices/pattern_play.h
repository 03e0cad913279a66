// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <optional>
#include <string>

namespace teleta::cli {

struct PlayOptions {
    std::string device = "usb"; ///< "usb", "simulated", or the file of a Modbus motor driver
    std::string motorsPath;     ///< profile of its motors; empty: that of the bracelet, if there is one
    bool overdrive = false;     ///< pattern::overdriven by that profile
    std::optional<double> measure_s;
    bool json = false;
};

/// Plays a pattern on a bracelet, once. With measure_s: over and over for so long, then setpoints as of a
/// live source for as long again, and prints how punctual the frames were. Ctrl-C ends it with the motors
/// off. Error: of the device or its files; refused when the playing ended early.
[[nodiscard]] core::Expected<void> playPattern(const pattern::Pattern& pattern, const PlayOptions& options);

} // namespace teleta::cli
