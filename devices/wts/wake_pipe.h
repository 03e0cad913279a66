// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace teleta::wts {

/// Ends a wait in poll() from another thread.
/// Thread: wake() from any, the others from one that owns the wait.
class WakePipe {
public:
    WakePipe();
    ~WakePipe();
    WakePipe(const WakePipe&) = delete;
    WakePipe& operator=(const WakePipe&) = delete;

    /// Ends the current wait and, until clear(), all further ones.
    void wake();
    void clear();
    /// Waits until awake or until the deadline (steady time).
    void waitUntil(std::int64_t deadline_ns) const;
    /// Readable while awake; -1 when the system had no descriptor left.
    [[nodiscard]] int descriptor() const { return m_ends[0]; }

private:
    int m_ends[2] = {-1, -1};
};

} // namespace teleta::wts
