// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// `teleta site`: what a site with a robot at another place needs.
[[nodiscard]] Command siteCommand();

} // namespace teleta::cli
