// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_frame_queue.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_camera_config.h"
#include "devices/simulated/simulated_link.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>

namespace teleta::simulated {

/// Makes the frames of a simulated camera when they are due,
///   due_k = epoch + (k + 1) / rate + lag
/// A world that takes longer than that to draw stands still meanwhile: late frames are not made up for.
/// Thread: run() is the worker's; open() before it; frames() for one consumer; the others from any.
class SimulatedCameraWorker {
public:
    SimulatedCameraWorker(std::unique_ptr<core::CameraGenerator> generator,
                          const core::StopSwitch& stopSwitch, SimulatedCameraConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token and its faults.
    void wake() { m_link.wake(); }

    void setFaults(const SimulatedFaults& faults) { m_link.setFaults(faults); }
    [[nodiscard]] SimulatedFaults faults() const { return m_link.faults(); }

    [[nodiscard]] const core::CameraDescription& description() const { return m_description; }
    [[nodiscard]] core::CameraFrameQueue& frames() { return m_frames; }
    [[nodiscard]] core::DeviceStatus status() const { return m_published.get(); }

private:
    void waitForPlug(SimulatedLink::Lock& lock, const std::stop_token& stop);
    void begin();
    void makeFrame(const SimulatedFaults& faults);
    void enter(core::DeviceState state, std::string message = {});
    void publish();

    std::unique_ptr<core::CameraGenerator> m_generator;
    const core::StopSwitch& m_stopSwitch;
    SimulatedCameraConfig m_config;
    core::CameraDescription m_description;
    core::CameraFrameQueue m_frames;
    core::LatestCopy<core::DeviceStatus> m_published;
    core::Wakeup* m_consumer = nullptr;
    SimulatedLink m_link;

    // The worker's own.
    core::RateMeter m_rate;
    core::DeviceStatus m_status;
    std::uint64_t m_number = 0;
    std::uint64_t m_lost = 0; ///< by the link or damaged
    bool m_discontinuity = false;
};

} // namespace teleta::simulated
