// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// `teleta ros`: topics and nodes of ROS 2 and what is sent there, without ROS.
[[nodiscard]] Command rosCommand();

} // namespace teleta::cli
