// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace teleta::core {

/// How soon the system runs a thread whose wait is over.
enum class ThreadUrgency {
    realTime, ///< before every ordinary thread (round robin)
    raised,   ///< an ordinary one with a higher priority
    ordinary, ///< the system permits nothing more
};

/// Makes the calling thread run as soon as its waits are over: with the highest urgency that the user is
/// allowed, and with timers that fire on time (the kernel may otherwise delay them by 50 us). Threads that it
/// starts do not inherit this. Returns what was reached.
[[nodiscard]] ThreadUrgency makeThreadUrgent();

/// Makes the calling thread run before ordinary ones, but after urgent ones: for work that others wait for
/// and that may take long. Returns what was reached: raised or ordinary.
[[nodiscard]] ThreadUrgency raiseThread();

/// The real-time priority for threads that libraries start for this program, just below that of
/// makeThreadUrgent(); empty: the user is not allowed any. Tried once, on a thread of its own. Thread: any.
[[nodiscard]] std::optional<int> libraryThreadPriority();

} // namespace teleta::core
