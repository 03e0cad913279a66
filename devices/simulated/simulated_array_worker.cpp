// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_array_worker.h"

#include "backend/core/device/device_state.h"
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
    , m_link(m_config.clock, m_description.nominalRate_Hz, m_config.faults, m_config.faultSeed)
    , m_values(m_description.layout.taxels())
    , m_stops(m_stopSwitch.engagements()) {
    // It may be released before the first frame.
    (void)lookAtStop();
}

void SimulatedArrayWorker::open(core::Wakeup& consumer) {
    m_outlet.open(consumer, m_link.now_ns());
}

void SimulatedArrayWorker::run(const std::stop_token& stop) {
    SimulatedLink::Lock lock = m_link.lock();
    connect();
    bool silent = false;
    while (!stop.stop_requested()) {
        const SimulatedFaults faults = m_link.faults(lock);
        if (faults.unplugged) {
            waitForPlug(lock, stop);
            continue;
        }
        const std::int64_t now_ns = m_link.now_ns();
        if (std::exchange(silent, faults.silent) && !faults.silent)
            m_link.restart();
        const std::int64_t next_ns =
            faults.silent ? core::PacingClock::kNever_ns : m_link.due_ns(faults.lag_s);
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
        m_link.waitUntil(lock, deadline_ns);
    }
    m_outlet.setState(core::DeviceState::closed, m_link.now_ns());
    m_discontinuity = true;
}

void SimulatedArrayWorker::connect() {
    m_link.restart();
    m_outlet.setState(core::DeviceState::connecting, m_link.now_ns());
}

void SimulatedArrayWorker::waitForPlug(SimulatedLink::Lock& lock, const std::stop_token& stop) {
    const std::string message =
        QCoreApplication::translate("SimulatedArrayDevice", "The device was unplugged.").toStdString();
    const auto enter = [&](core::DeviceState state) { m_outlet.setState(state, m_link.now_ns(), message); };
    if (!m_link.waitForPlug(lock, stop, enter))
        return;
    m_discontinuity = true;
    connect();
}

void SimulatedArrayWorker::readDue(const SimulatedFaults& faults, std::int64_t now_ns) {
    const std::int64_t late_ns = now_ns - m_link.due_ns(faults.lag_s);
    if (late_ns > toNs(m_config.longestCatchUp_s))
        m_link.standStill(late_ns);

    core::SampleBlock block;
    for (std::size_t i = 0; i < kFramesPerBlock && m_link.due_ns(faults.lag_s) <= now_ns; ++i) {
        const bool stopped = lookAtStop();
        if (m_config.scene && m_config.scene->takeRestart(stopped)) {
            deliver(block); // a jump is told at the beginning of a block
            m_generator->restart();
            m_discontinuity = true;
        }
        m_generator->next(m_values, stopped || (m_config.scene && m_config.scene->isHeld()));
        m_link.count();
        if (m_link.happens(faults.dropShare)) {
            deliver(block); // frames of a block are consecutive
            m_outlet.lose(1);
            continue;
        }
        block.time_ns.push_back(m_link.now_ns());
        block.sourceTime_s.push_back(m_generator->time_s());
        block.values.insert(block.values.end(), m_values.begin(), m_values.end());
    }
    deliver(block);
}

/// STOP is engaged. A scene that it held, also between two frames, does not go on by itself.
bool SimulatedArrayWorker::lookAtStop() {
    const bool stopped = m_stopSwitch.engaged();
    const std::uint64_t stops = m_stopSwitch.engagements();
    if (m_config.scene && (stopped || stops != m_stops))
        m_config.scene->setRunning(false);
    m_stops = stops;
    return stopped;
}

void SimulatedArrayWorker::deliver(core::SampleBlock& block) {
    if (block.frames() == 0)
        return;
    block.channels = m_values.size();
    block.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::exchange(block, {}), core::DeviceState::live);
}

} // namespace teleta::simulated
