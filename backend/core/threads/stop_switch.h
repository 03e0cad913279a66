// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"

#include <atomic>
#include <cstdint>

namespace teleta::core {

/// The STOP of the whole program. Whatever moves or drives an actuator looks at it first, in every cycle, and
/// goes to zero while it is engaged. It stays engaged until a person releases it. Thread: any, lock-free.
class StopSwitch {
public:
    void engage() {
        std::int64_t running = 0;
        if (m_engagedSince_ns.compare_exchange_strong(running, steadyNow_ns(), std::memory_order_acq_rel))
            m_engagements.fetch_add(1, std::memory_order_acq_rel);
    }
    void release() { m_engagedSince_ns.store(0, std::memory_order_release); }

    [[nodiscard]] bool engaged() const { return m_engagedSince_ns.load(std::memory_order_acquire) != 0; }
    /// Steady time of the press that engaged it; 0 while it is not engaged.
    [[nodiscard]] std::int64_t engagedSince_ns() const {
        return m_engagedSince_ns.load(std::memory_order_acquire);
    }

    /// How often it was engaged. Shows a reader that it was engaged and released between two checks.
    [[nodiscard]] std::uint64_t engagements() const { return m_engagements.load(std::memory_order_acquire); }

private:
    std::atomic<std::int64_t> m_engagedSince_ns{0};
    std::atomic<std::uint64_t> m_engagements{0};
};

} // namespace teleta::core
