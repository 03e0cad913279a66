// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "devices/simulated/simulated_array_config.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <stop_token>

namespace teleta::simulated {

/// The way from a simulated device to the program: when the k-th sample since the epoch arrives,
///   due_k = epoch + (k + 1) / rate + lag,
/// what is lost on it, and how a worker waits. Thread: wake(), setFaults() and faults() any; the others are
/// the worker's, those with a Lock while it holds it.
class SimulatedLink {
public:
    using Lock = std::unique_lock<std::mutex>;

    SimulatedLink(std::shared_ptr<core::PacingClock> clock, double rate_Hz, const SimulatedFaults& faults,
                  std::uint64_t faultSeed);

    /// Ends a wait, so that the worker looks at its stop token and the faults.
    void wake();
    void setFaults(const SimulatedFaults& faults);
    [[nodiscard]] SimulatedFaults faults() const;

    [[nodiscard]] Lock lock() { return Lock(m_mutex); }
    [[nodiscard]] const SimulatedFaults& faults(const Lock&) const { return m_faults; }
    void waitUntil(Lock& lock, std::int64_t deadline_ns);
    /// Behaves as a driver does whose device is gone: says so, then tries again less and less often. False
    /// when it is to stop instead.
    [[nodiscard]] bool waitForPlug(Lock& lock, const std::stop_token& stop,
                                   const std::function<void(core::DeviceState)>& enter);

    [[nodiscard]] std::int64_t now_ns() const { return m_clock->now_ns(); }
    /// Begins to count anew, now.
    void restart();
    /// The world stood still for so long.
    void standStill(std::int64_t late_ns) { m_epoch_ns += late_ns; }
    [[nodiscard]] std::int64_t due_ns(double lag_s) const;
    void count() { ++m_sinceEpoch; }
    /// Draws whether something happens that happens to this share, 0 .. 1.
    [[nodiscard]] bool happens(double share);

private:
    std::shared_ptr<core::PacingClock> m_clock;
    double m_rate_Hz;
    mutable std::mutex m_mutex;
    std::condition_variable m_condition;
    SimulatedFaults m_faults; ///< guarded by m_mutex
    std::mt19937_64 m_random;
    std::int64_t m_epoch_ns = 0;
    std::uint64_t m_sinceEpoch = 0; ///< samples
};

} // namespace teleta::simulated
