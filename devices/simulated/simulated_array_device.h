// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_array_config.h"
#include "devices/simulated/simulated_array_worker.h"

#include <memory>
#include <utility>

namespace teleta::simulated {

/// A simulated tactile array that behaves like a connected one: frames in real time, and faults on demand.
///   connecting -> live <-> stale; unplugged: lost -> reconnecting -> connecting; stop(): closed
/// While STOP is engaged or the scene is held, the simulated motion stands still and frames go on.
/// Thread: start, stop from one controlling thread, setFaults from any; otherwise as core::TactileSource.
class SimulatedArrayDevice : public core::TactileSource {
public:
    /// generator: not null, with a frame rate above 0. stopSwitch must outlive the device.
    SimulatedArrayDevice(std::unique_ptr<core::FrameGenerator> generator, const core::StopSwitch& stopSwitch,
                         SimulatedArrayConfig config = {})
        : m_description(generator->description())
        , m_worker(std::move(generator), stopSwitch, std::move(config)) {}

    [[nodiscard]] const core::SourceDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override {
        return m_worker.outlet().blocks();
    }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker.outlet().status(); }

    void setFaults(const SimulatedFaults& faults) { m_worker.setFaults(faults); }
    [[nodiscard]] SimulatedFaults faults() const { return m_worker.faults(); }

private:
    core::SourceDescription m_description;
    SimulatedArrayWorker m_worker;
    core::DeviceThread<SimulatedArrayWorker> m_thread{m_worker};
};

} // namespace teleta::simulated
