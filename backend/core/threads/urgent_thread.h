// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::core {

/// How soon the system lets a thread run that has waited.
enum class ThreadUrgency {
    realTime, ///< before every ordinary thread (round robin)
    raised,   ///< an ordinary one with a higher priority
    ordinary, ///< the system permits nothing more
};

/// Lets the calling thread, which waits most of the time, run as soon as its wait is over: as much of
/// realTime, raised as the user may, and timers that fire on time (the kernel may else gather them over 50
/// us). Threads that it makes do not inherit it. Returns what was reached.
[[nodiscard]] ThreadUrgency makeThreadUrgent();

} // namespace teleta::core
