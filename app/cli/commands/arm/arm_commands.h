// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// `teleta arm`: robot arms.
[[nodiscard]] Command armCommand();

} // namespace teleta::cli
