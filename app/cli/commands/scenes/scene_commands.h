// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// Runs a scene as fast as it can and reports its measures.
[[nodiscard]] Command simulateCommand();
/// User studies with simulated participants, and the results of all.
[[nodiscard]] Command studyCommand();
/// Measures what accuracy costs in time, here and now.
[[nodiscard]] Command tradeoffCommand();

} // namespace teleta::cli
