// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/file_descriptor.h"

#include <cstdint>
#include <poll.h>
#include <span>

namespace teleta::link {

/// Waits for events until the deadline (steady time), even if a signal interrupts the wait. Result: that
/// of ppoll().
int pollUntil(std::span<pollfd> polled, std::int64_t deadline_ns);

/// Ends a wait in poll() from another thread.
/// Thread: wake() from any, the others from one that owns the wait.
class WakePipe {
public:
    WakePipe();

    /// Ends the current wait and, until clear(), all further ones.
    void wake();
    void clear();
    /// Waits until awake or until the deadline (steady time).
    void waitUntil(std::int64_t deadline_ns) const;
    /// Readable while awake; -1 when the system had no descriptor left.
    [[nodiscard]] int descriptor() const { return m_read.get(); }

private:
    core::FileDescriptor m_read{-1};
    core::FileDescriptor m_write{-1};
};

} // namespace teleta::link
