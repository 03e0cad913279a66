// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/interface.h"
#include "backend/core/random_stream.h"
#include "backend/core/threads/pacing_clock.h"

#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

namespace teleta::simulated {

/// What goes wrong with a simulated device and its link, for tests and demonstrations.
struct SimulatedFaults {
    double lag_s = 0.0;     ///< frames come so much later; 0 .. 3600
    double dropShare = 0.0; ///< share of the frames that the link loses, 0 .. 1; each is counted
    bool silent = false;    ///< connected, but no frame comes
    bool unplugged = false; ///< lost, with attempts to connect again until it is plugged in

    bool operator==(const SimulatedFaults&) const = default;
};

[[nodiscard]] inline std::int64_t toNs(double time_s) {
    return static_cast<std::int64_t>(std::llround(time_s * 1e9));
}

/// The worker of a simulated device and the faults of its link: makes the k-th sample since the epoch when it
/// is due,
///   due_k = epoch + (k + 1) / rate + lag,
/// so that a late sample does not delay the next ones.
/// Thread: run() is the worker's, and so is what is protected; the rest from any.
class SimulatedWorker : public core::Interface {
public:
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token and its faults.
    void wake();

    void setFaults(const SimulatedFaults& faults);
    [[nodiscard]] SimulatedFaults faults() const;
    [[nodiscard]] std::int64_t now_ns() const { return m_clock->now_ns(); }

protected:
    SimulatedWorker(std::shared_ptr<core::PacingClock> clock, double rate_Hz, const SimulatedFaults& faults,
                    std::uint64_t faultSeed);

    virtual void setState(core::DeviceState state, const std::string& message) = 0;
    /// The connection has ended: what comes next does not follow what came before.
    virtual void disconnected() = 0;
    /// Makes the samples that are due at now_ns. Called without the lock.
    virtual void makeDue(const SimulatedFaults& faults, std::int64_t now_ns) = 0;
    /// Nothing is due. Returns when to look again at the latest.
    virtual std::int64_t idle(const SimulatedFaults& faults, std::int64_t now_ns) = 0;
    /// The link has begun or ceased to be silent.
    virtual void silenceChanged() {}
    /// Why an unplugged device is lost, translated.
    [[nodiscard]] virtual std::string unpluggedMessage() const = 0;

    [[nodiscard]] std::int64_t due_ns(double lag_s) const;
    /// A sample was made.
    void count() { ++m_sinceEpoch; }
    /// The world stood still for this long.
    void standStill(std::int64_t late_ns) { m_epoch_ns += late_ns; }
    /// True with this probability, 0 .. 1.
    [[nodiscard]] bool happens(double share) { return m_random.uniform() < share; }

private:
    void connect();
    void waitForPlug(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);

    std::shared_ptr<core::PacingClock> m_clock;
    double m_rate_Hz;
    mutable std::mutex m_mutex;
    std::condition_variable m_condition;
    SimulatedFaults m_faults; ///< guarded by m_mutex
    core::RandomStream m_random;
    std::int64_t m_epoch_ns = 0;
    std::uint64_t m_sinceEpoch = 0; ///< samples
};

/// Marks an outlet whose newest data is too old as stale. Returns when it will be too old.
template <typename Outlet>
[[nodiscard]] std::int64_t watchAge(Outlet& outlet, std::int64_t staleAfter_ns, std::int64_t now_ns) {
    const std::int64_t stale_ns = outlet.lastData_ns() + staleAfter_ns;
    if (outlet.state() == core::DeviceState::live && now_ns < stale_ns)
        return stale_ns;
    if (outlet.state() == core::DeviceState::live)
        outlet.setState(core::DeviceState::stale, now_ns);
    return core::PacingClock::kNever_ns;
}

} // namespace teleta::simulated
