// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/stop_switch.h"

#include <atomic>
#include <cstdint>

namespace teleta::pipeline {

/// Whether an arm may react to touch. STOP takes the permission away until it is given again; while it is
/// engaged none is given. Thread: any.
class ReactionPermission {
public:
    /// stop: outlives it.
    explicit ReactionPermission(const core::StopSwitch& stop)
        : m_stop(stop) {}

    void give(bool given) {
        // In this order, so that no STOP in between is missed.
        const std::uint64_t engagements = m_stop.engagements();
        m_permission.store(given && !m_stop.engaged() ? engagements : kNone, std::memory_order_release);
        m_asked.store(true, std::memory_order_release);
    }
    [[nodiscard]] bool isGiven() const {
        const std::uint64_t permission = m_permission.load(std::memory_order_acquire);
        return !m_stop.engaged() && permission == m_stop.engagements();
    }
    /// Whether give() was called since the last time: who asked waits for the answer, also when it is the
    /// same as before.
    [[nodiscard]] bool takeAsked() { return m_asked.exchange(false, std::memory_order_acq_rel); }

private:
    static constexpr std::uint64_t kNone = ~std::uint64_t{0};
    const core::StopSwitch& m_stop;
    std::atomic<std::uint64_t> m_permission{kNone}; ///< how often STOP had been engaged when it was given
    std::atomic<bool> m_asked{false};
};

} // namespace teleta::pipeline
