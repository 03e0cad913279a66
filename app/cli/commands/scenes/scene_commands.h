// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// Runs a scene as fast as it can and reports its measures.
[[nodiscard]] Command simulateCommand();
/// Rehearses user studies with simulated participants, and analyses and exports studies.
[[nodiscard]] Command studyCommand();
/// Measures what accuracy costs in time on this machine.
[[nodiscard]] Command tradeoffCommand();

} // namespace teleta::cli
