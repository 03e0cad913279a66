// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_worker.h"

#include "backend/core/device/backoff.h"

#include <algorithm>
#include <utility>

namespace teleta::simulated {

namespace {

/// Longest lag of a simulated device.
constexpr double kLongestLag_s = 3600.0;
/// Delays of an unplugged device before it is looked for again.
constexpr std::int64_t kFirstRetry_ns = 100'000'000;
constexpr std::int64_t kLongestRetry_ns = 2'000'000'000;

} // namespace

SimulatedWorker::SimulatedWorker(std::shared_ptr<core::PacingClock> clock, double rate_Hz,
                                 const SimulatedFaults& faults, std::uint64_t faultSeed)
    : m_clock(std::move(clock))
    , m_rate_Hz(rate_Hz)
    , m_faults(faults)
    , m_random(faultSeed) {
}

void SimulatedWorker::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

void SimulatedWorker::setFaults(const SimulatedFaults& faults) {
    const std::scoped_lock lock(m_mutex);
    m_faults = faults;
    m_condition.notify_all();
}

SimulatedFaults SimulatedWorker::faults() const {
    const std::scoped_lock lock(m_mutex);
    return m_faults;
}

void SimulatedWorker::run(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    connect();
    bool silent = false;
    while (!stop.stop_requested()) {
        const SimulatedFaults faults = m_faults;
        if (faults.unplugged) {
            waitForPlug(lock, stop);
            continue;
        }
        if (std::exchange(silent, faults.silent) != faults.silent) {
            silenceChanged();
            m_epoch_ns = now_ns();
            m_sinceEpoch = 0;
        }
        const std::int64_t now = now_ns();
        const std::int64_t next_ns = silent ? core::PacingClock::kNever_ns : due_ns(faults.lag_s);
        if (next_ns <= now) {
            lock.unlock();
            makeDue(faults, now);
            lock.lock();
        } else {
            const std::int64_t deadline_ns = std::min(next_ns, idle(faults, now));
            m_clock->waitUntil(m_condition, lock, deadline_ns);
        }
    }
    disconnected();
    setState(core::DeviceState::closed, {});
}

void SimulatedWorker::connect() {
    m_epoch_ns = now_ns();
    m_sinceEpoch = 0;
    setState(core::DeviceState::connecting, {});
}

/// Behaves like a driver whose device is gone: reports the loss, then retries less and less often.
void SimulatedWorker::waitForPlug(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const std::string message = unpluggedMessage();
    disconnected();
    setState(core::DeviceState::lost, message);
    core::Backoff retry(kFirstRetry_ns, kLongestRetry_ns);
    while (m_clock->sleepUntil(m_condition, lock, now_ns() + retry.next_ns(), stop)) {
        setState(core::DeviceState::reconnecting, message);
        if (!m_faults.unplugged) {
            disconnected(); // again: what was asked for meanwhile does not count
            connect();
            return;
        }
    }
}

std::int64_t SimulatedWorker::due_ns(double lag_s) const {
    const double since_s = static_cast<double>(m_sinceEpoch + 1) / m_rate_Hz;
    return m_epoch_ns + toNs(since_s + (lag_s > 0.0 ? std::min(lag_s, kLongestLag_s) : 0.0));
}

} // namespace teleta::simulated
