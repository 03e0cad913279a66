// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// `teleta certify`: injects faults into what drives the motors and reports how soon they are at zero.
[[nodiscard]] Command certifyCommand();

} // namespace teleta::cli
