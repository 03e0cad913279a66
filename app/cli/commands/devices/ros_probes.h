// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commands/devices/found_device.h"
#include "backend/core/error.h"

#include <string>

namespace teleta::cli {

/// Listens to a tactile array or a camera over ROS 2 for a second from its first message on, and for three
/// seconds if none comes. Error: of the file; what is wrong on the wire is in FoundDevice::error. Thread:
/// one.
[[nodiscard]] core::Expected<FoundDevice> probeRosArray(const std::string& path);
[[nodiscard]] core::Expected<FoundDevice> probeRosCamera(const std::string& path);

} // namespace teleta::cli
