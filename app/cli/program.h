// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::cli {

/// Parses the command line, runs the command and returns the exit code (ExitCode). Needs a QCoreApplication.
[[nodiscard]] int runProgram(int argc, const char* const* argv);

} // namespace teleta::cli
