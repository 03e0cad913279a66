// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_array_device.h"

#include "backend/core/device/device_state.h"

#include <QCoreApplication>

#include <algorithm>
#include <string>
#include <utility>

namespace teleta::simulated {

namespace {

constexpr std::size_t kFramesPerBlock = 64;

} // namespace

SimulatedArrayDevice::SimulatedArrayDevice(std::unique_ptr<core::FrameGenerator> generator,
                                           const core::StopSwitch& stopSwitch, SimulatedArrayConfig config)
    : SimulatedWorker(config.clock, generator->description().nominalRate_Hz, config.faults, config.faultSeed)
    , m_generator(std::move(generator))
    , m_stopSwitch(stopSwitch)
    , m_config(std::move(config))
    , m_description(m_generator->description())
    , m_staleAfter_ns(m_config.staleAfter_s ? toNs(*m_config.staleAfter_s)
                                            : core::staleAfter_ns(m_description.nominalRate_Hz))
    , m_outlet(m_config.queueBlocks)
    , m_values(m_description.layout.taxels())
    , m_stops(m_stopSwitch.engagements()) {
    // STOP may be released before the first frame.
    (void)lookAtStop();
}

std::string SimulatedArrayDevice::unpluggedMessage() const {
    return QCoreApplication::translate("SimulatedArrayDevice", "The device was unplugged.").toStdString();
}

void SimulatedArrayDevice::makeDue(const SimulatedFaults& faults, std::int64_t now_ns) {
    const std::int64_t late_ns = now_ns - due_ns(faults.lag_s);
    if (late_ns > toNs(m_config.longestCatchUp_s))
        standStill(late_ns);

    core::SampleBlock block;
    for (std::size_t i = 0; i < kFramesPerBlock && due_ns(faults.lag_s) <= now_ns; ++i) {
        const bool stopped = lookAtStop();
        if (m_config.scene && m_config.scene->takeRestart(stopped)) {
            deliver(block); // a jump is told at the beginning of a block
            m_generator->restart();
            m_discontinuity = true;
        }
        m_generator->next(m_values, stopped || (m_config.scene && m_config.scene->isHeld()));
        count();
        if (happens(faults.dropShare)) {
            deliver(block); // frames of a block are consecutive
            m_outlet.lose(1);
            continue;
        }
        block.time_ns.push_back(SimulatedWorker::now_ns());
        block.sourceTime_s.push_back(m_generator->time_s());
        block.values.insert(block.values.end(), m_values.begin(), m_values.end());
    }
    deliver(block);
}

/// Whether STOP is engaged. A scene that it held, even if only between two frames, does not resume by itself.
bool SimulatedArrayDevice::lookAtStop() {
    const bool stopped = m_stopSwitch.engaged();
    const std::uint64_t stops = m_stopSwitch.engagements();
    if (m_config.scene && (stopped || stops != m_stops))
        m_config.scene->setRunning(false);
    m_stops = stops;
    return stopped;
}

void SimulatedArrayDevice::deliver(core::SampleBlock& block) {
    if (block.frames() == 0)
        return;
    block.channels = m_values.size();
    block.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::exchange(block, {}), core::DeviceState::live);
}

} // namespace teleta::simulated
