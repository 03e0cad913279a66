// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

namespace teleta::cli {

/// Makes Ctrl-C (SIGINT) and SIGTERM a request to finish: long work looks at interrupted(), completes its
/// files and returns interruption(). A second Ctrl-C ends the program at once. Reading from a pipe that waits
/// is interrupted (ErrorKind::cancelled).
void catchInterruptions();

[[nodiscard]] bool interrupted();

/// The error with which interrupted work ends.
[[nodiscard]] core::Error interruption();

} // namespace teleta::cli
