// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/threads/device_thread.h"
#include "devices/simulated/simulated_camera_worker.h"

#include <memory>
#include <utility>

namespace teleta::simulated {

/// A simulated camera that behaves like a connected one: frames in real time, and faults on demand.
///   connecting -> live; unplugged: lost -> reconnecting -> connecting; stop(): closed
/// Readers find out by themselves whether it is stale (core::observedState). While STOP is engaged the
/// camera's carrier stands still and frames keep coming.
/// Thread: start, stop from one controlling thread, setFaults from any; otherwise as core::CameraSource.
class SimulatedCameraDevice : public core::CameraSource {
public:
    /// generator: not null, with a rate above 0. stopSwitch must outlive the device.
    SimulatedCameraDevice(std::unique_ptr<core::CameraGenerator> generator,
                          const core::StopSwitch& stopSwitch, SimulatedCameraConfig config = {})
        : m_worker(std::move(generator), stopSwitch, std::move(config)) {}

    [[nodiscard]] const core::CameraDescription& description() const override {
        return m_worker.description();
    }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    bool pop(core::CameraFrame& frame) override { return m_worker.frames().pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker.status(); }

    void setFaults(const SimulatedFaults& faults) { m_worker.setFaults(faults); }
    [[nodiscard]] SimulatedFaults faults() const { return m_worker.faults(); }

private:
    SimulatedCameraWorker m_worker;
    core::DeviceThread<SimulatedCameraWorker> m_thread{m_worker};
};

} // namespace teleta::simulated
