// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_outlet.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_worker.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace teleta::simulated {

struct SimulatedCameraConfig {
    std::size_t queueFrames = 8;
    SimulatedFaults faults{};
    double undecodableShare = 0.0; ///< share of the frames that arrive damaged, 0 .. 1; each is counted
    std::uint64_t faultSeed = 1;   ///< which frames are dropped or damaged
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

/// A simulated camera that behaves like a connected one: frames in real time, and faults on demand. If
/// drawing takes longer than a period, the world stands still in the meantime: late frames are not made up
/// for.
///   connecting -> live; unplugged: lost -> reconnecting -> connecting; stop(): closed
/// Readers find out by themselves whether it is stale (core::observedState). While STOP is engaged the
/// camera's carrier stands still and frames keep coming.
/// Thread: start, stop from one controlling thread, setFaults from any; otherwise as core::CameraSource.
class SimulatedCameraDevice : public core::CameraSource, private SimulatedWorker {
public:
    /// generator: not null, with a rate above 0. stopSwitch must outlive the device.
    SimulatedCameraDevice(std::unique_ptr<core::CameraGenerator> generator,
                          const core::StopSwitch& stopSwitch, SimulatedCameraConfig config = {});

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    bool pop(core::CameraFrame& frame) override { return m_outlet.frames().pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    using SimulatedWorker::faults;
    using SimulatedWorker::setFaults;

private:
    friend core::DeviceThread<SimulatedCameraDevice>;
    void open(core::Wakeup& consumer);

    void setState(core::DeviceState state, const std::string& message) override {
        m_outlet.setState(state, now_ns(), message);
    }
    void disconnected() override { m_discontinuity = true; }
    void makeDue(const SimulatedFaults& faults, std::int64_t now_ns) override;
    std::int64_t idle(const SimulatedFaults&, std::int64_t) override { return core::PacingClock::kNever_ns; }
    [[nodiscard]] std::string unpluggedMessage() const override;

    void makeFrame(const SimulatedFaults& faults);

    std::unique_ptr<core::CameraGenerator> m_generator;
    const core::StopSwitch& m_stopSwitch;
    SimulatedCameraConfig m_config;
    core::CameraDescription m_description;
    core::CameraOutlet m_outlet;

    // The worker's own.
    std::uint64_t m_number = 0;
    bool m_discontinuity = false;

    core::DeviceThread<SimulatedCameraDevice> m_thread{*this};
};

} // namespace teleta::simulated
