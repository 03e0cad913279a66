// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_link.h"

#include "devices/simulated/simulated_times.h"

#include <algorithm>
#include <utility>

namespace teleta::simulated {

namespace {

/// A simulated device lags at most so much.
constexpr double kLongestLag_s = 3600.0;
/// How long a device that is unplugged waits before it looks again: first, and at the most.
constexpr std::int64_t kFirstRetry_ns = 100'000'000;
constexpr std::int64_t kLongestRetry_ns = 2'000'000'000;

} // namespace

SimulatedLink::SimulatedLink(std::shared_ptr<core::PacingClock> clock, double rate_Hz,
                             const SimulatedFaults& faults, std::uint64_t faultSeed)
    : m_clock(std::move(clock))
    , m_rate_Hz(rate_Hz)
    , m_faults(faults)
    , m_random(faultSeed) {
}

void SimulatedLink::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

void SimulatedLink::setFaults(const SimulatedFaults& faults) {
    const std::scoped_lock lock(m_mutex);
    m_faults = faults;
    m_condition.notify_all();
}

SimulatedFaults SimulatedLink::faults() const {
    const std::scoped_lock lock(m_mutex);
    return m_faults;
}

void SimulatedLink::waitUntil(Lock& lock, std::int64_t deadline_ns) {
    m_clock->waitUntil(m_condition, lock, deadline_ns);
}

bool SimulatedLink::waitForPlug(Lock& lock, const std::stop_token& stop,
                                const std::function<void(core::DeviceState)>& enter) {
    enter(core::DeviceState::lost);
    for (std::int64_t retry_ns = kFirstRetry_ns;; retry_ns = std::min(2 * retry_ns, kLongestRetry_ns)) {
        const std::int64_t deadline_ns = now_ns() + retry_ns;
        while (now_ns() < deadline_ns) {
            if (stop.stop_requested())
                return false;
            waitUntil(lock, deadline_ns);
        }
        enter(core::DeviceState::reconnecting);
        if (!m_faults.unplugged)
            return true;
    }
}

void SimulatedLink::restart() {
    m_epoch_ns = now_ns();
    m_sinceEpoch = 0;
}

std::int64_t SimulatedLink::due_ns(double lag_s) const {
    const double since_s = static_cast<double>(m_sinceEpoch + 1) / m_rate_Hz;
    return m_epoch_ns + toNs(since_s + (lag_s > 0.0 ? std::min(lag_s, kLongestLag_s) : 0.0));
}

bool SimulatedLink::happens(double share) {
    return static_cast<double>(m_random() >> 11) * 0x1.0p-53 < share;
}

} // namespace teleta::simulated
