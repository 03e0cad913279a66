// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

namespace teleta::cli {

/// Makes Ctrl-C (SIGINT), SIGTERM and a terminal that closes (SIGHUP) a request to finish: long work looks at
/// interrupted(), completes its files and returns interruption(). A second Ctrl-C ends the program at once; a
/// SIGHUP that was ignored when the program began stays ignored. Reading from a pipe that waits
/// is interrupted (ErrorKind::cancelled).
void catchInterruptions();

[[nodiscard]] bool interrupted();

/// The error with which interrupted work ends.
[[nodiscard]] core::Error interruption();
/// interruption() for ErrorKind::cancelled, which has no text of its own; any other error as it is.
[[nodiscard]] core::Error interruptedInstead(core::Error error);
/// The outcome of completing the output: interruption() when that went well but the work was cut short.
[[nodiscard]] core::Expected<void> unlessCut(core::Expected<void> completed, bool cut);
/// The same; cut if interrupted() by now, also while the output was completed.
[[nodiscard]] core::Expected<void> unlessCut(core::Expected<void> completed);

/// Standard output is a pipe that nobody reads any more.
[[nodiscard]] bool readerIsGone();

/// Ends the program as such a pipe ends others: by SIGPIPE, without a word. Whoever started it sees why.
void endUnread();

} // namespace teleta::cli
