// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_outlet.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_camera_config.h"
#include "devices/simulated/simulated_worker.h"

#include <cstdint>
#include <memory>
#include <string>

namespace teleta::simulated {

/// Makes the frames of a simulated camera when they are due,
///   due_k = epoch + (k + 1) / rate + lag
/// If drawing takes longer than a period, the world stands still in the meantime: late frames are not made up
/// for.
/// Thread: run() is the worker's; open() before it; frames() for one consumer; the others from any.
class SimulatedCameraWorker : public SimulatedWorker {
public:
    SimulatedCameraWorker(std::unique_ptr<core::CameraGenerator> generator,
                          const core::StopSwitch& stopSwitch, SimulatedCameraConfig config);

    void open(core::Wakeup& consumer);

    [[nodiscard]] const core::CameraDescription& description() const { return m_description; }
    [[nodiscard]] core::CameraFrameQueue& frames() { return m_outlet.frames(); }
    [[nodiscard]] core::DeviceStatus status() const { return m_outlet.status(); }

private:
    void setState(core::DeviceState state, const std::string& message) override;
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
};

} // namespace teleta::simulated
