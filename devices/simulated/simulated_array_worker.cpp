// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_array_worker.h"

#include "backend/core/device_state.h"
#include "devices/simulated/simulated_times.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace teleta::simulated {

namespace {

constexpr std::size_t kFramesPerBlock = 64;

} // namespace

SimulatedArrayWorker::SimulatedArrayWorker(std::unique_ptr<core::FrameGenerator> generator,
                                           const core::StopSwitch& stopSwitch, SimulatedArrayConfig config)
    : m_generator(std::move(generator))
    , m_stopSwitch(stopSwitch)
    , m_config(std::move(config))
    , m_description(m_generator->description())
    , m_staleAfter_ns(m_config.staleAfter_s ? toNs(*m_config.staleAfter_s)
                                            : core::staleAfter_ns(m_description.nominalRate_Hz))
    , m_outlet(m_config.queueBlocks)
    , m_faults(m_config.faults)
    , m_dropRandom(m_config.faultSeed)
    , m_values(m_description.layout.taxels()) {
}

void SimulatedArrayWorker::open(core::Wakeup& consumer) {
    m_outlet.open(consumer, m_config.clock->now_ns());
}

void SimulatedArrayWorker::run(const std::stop_token& stop) {
    Lock lock(m_mutex);
    connect();
    bool silent = false;
    while (!stop.stop_requested()) {
        const SimulatedFaults faults = m_faults;
        if (faults.unplugged) {
            waitForPlug(lock, stop);
            continue;
        }
        const std::int64_t now_ns = m_config.clock->now_ns();
        if (std::exchange(silent, faults.silent) && !faults.silent) {
            m_epoch_ns = now_ns;
            m_sinceEpoch = 0;
        }
        const std::int64_t next_ns = faults.silent ? core::PacingClock::kNever_ns : due_ns(faults.lag_s);
        if (next_ns <= now_ns) {
            lock.unlock();
            readDue(faults, now_ns);
            lock.lock();
            continue;
        }
        std::int64_t deadline_ns = next_ns;
        if (m_outlet.state() == core::DeviceState::live) {
            const std::int64_t stale_ns = m_outlet.lastData_ns() + m_staleAfter_ns;
            if (now_ns >= stale_ns)
                m_outlet.setState(core::DeviceState::stale, now_ns);
            else
                deadline_ns = std::min(deadline_ns, stale_ns);
        }
        m_config.clock->waitUntil(m_condition, lock, deadline_ns);
    }
    m_outlet.setState(core::DeviceState::closed, m_config.clock->now_ns());
    m_discontinuity = true;
}

void SimulatedArrayWorker::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

void SimulatedArrayWorker::setFaults(const SimulatedFaults& faults) {
    const std::scoped_lock lock(m_mutex);
    m_faults = faults;
    m_condition.notify_all();
}

SimulatedFaults SimulatedArrayWorker::faults() const {
    const std::scoped_lock lock(m_mutex);
    return m_faults;
}

void SimulatedArrayWorker::connect() {
    m_epoch_ns = m_config.clock->now_ns();
    m_sinceEpoch = 0;
    m_outlet.setState(core::DeviceState::connecting, m_epoch_ns);
}

/// Behaves as a driver does whose device is gone: says so, then tries again less and less often.
void SimulatedArrayWorker::waitForPlug(Lock& lock, const std::stop_token& stop) {
    core::PacingClock& clock = *m_config.clock;
    const std::string message =
        QCoreApplication::translate("SimulatedArrayDevice", "The device was unplugged.").toStdString();
    m_outlet.setState(core::DeviceState::lost, clock.now_ns(), message);
    for (std::int64_t retry_ns = kFirstRetry_ns;; retry_ns = std::min(2 * retry_ns, kLongestRetry_ns)) {
        const std::int64_t deadline_ns = clock.now_ns() + retry_ns;
        while (clock.now_ns() < deadline_ns) {
            if (stop.stop_requested())
                return;
            clock.waitUntil(m_condition, lock, deadline_ns);
        }
        m_outlet.setState(core::DeviceState::reconnecting, clock.now_ns(), message);
        if (!m_faults.unplugged)
            break;
    }
    m_discontinuity = true;
    connect();
}

std::int64_t SimulatedArrayWorker::due_ns(double lag_s) const {
    const double since_s = static_cast<double>(m_sinceEpoch + 1) / m_description.nominalRate_Hz;
    return m_epoch_ns + toNs(since_s + (lag_s > 0.0 ? std::min(lag_s, kLongestLag_s) : 0.0));
}

void SimulatedArrayWorker::readDue(const SimulatedFaults& faults, std::int64_t now_ns) {
    const std::int64_t late_ns = now_ns - due_ns(faults.lag_s);
    if (late_ns > toNs(m_config.longestCatchUp_s))
        m_epoch_ns += late_ns;

    core::SampleBlock block;
    for (std::size_t i = 0; i < kFramesPerBlock && due_ns(faults.lag_s) <= now_ns; ++i) {
        m_generator->next(m_values, m_stopSwitch.engaged());
        ++m_sinceEpoch;
        if (static_cast<double>(m_dropRandom() >> 11) * 0x1.0p-53 < faults.dropShare) {
            deliver(block); // frames of a block are consecutive
            m_outlet.lose(1);
            continue;
        }
        block.time_ns.push_back(m_config.clock->now_ns());
        block.sourceTime_s.push_back(m_generator->time_s());
        block.values.insert(block.values.end(), m_values.begin(), m_values.end());
    }
    deliver(block);
}

void SimulatedArrayWorker::deliver(core::SampleBlock& block) {
    if (block.frames() == 0)
        return;
    block.channels = m_values.size();
    block.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::exchange(block, {}), core::DeviceState::live);
}

} // namespace teleta::simulated
