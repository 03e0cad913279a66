// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

#include <vector>

namespace teleta::cli {

/// Runs one of these commands as a process does: makes the QCoreApplication, parses the command line and
/// returns the exit code (ExitCode). commands is called once the texts can be translated.
[[nodiscard]] int runProgram(int argc, char** argv, std::vector<Command> (*commands)());

} // namespace teleta::cli
