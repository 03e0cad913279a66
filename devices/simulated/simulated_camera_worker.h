// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bounded_queue.h"
#include "backend/core/camera_source.h"
#include "backend/core/latest_copy.h"
#include "backend/core/rate_meter.h"
#include "backend/core/stop_switch.h"
#include "devices/simulated/simulated_camera_config.h"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <random>
#include <stop_token>
#include <string>

namespace teleta::simulated {

/// Makes the frames of a simulated camera when they are due,
///   due_k = epoch + k / rate + lag
/// A world that takes longer than that to draw stands still meanwhile: late frames are not made up for.
/// Thread: run() is the worker's; open() before it; frames() for one consumer; the others from any.
class SimulatedCameraWorker {
public:
    SimulatedCameraWorker(std::unique_ptr<core::CameraGenerator> generator,
                          const core::StopSwitch& stopSwitch, SimulatedCameraConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token and its faults.
    void wake();

    void setFaults(const SimulatedFaults& faults);
    [[nodiscard]] SimulatedFaults faults() const;

    [[nodiscard]] const core::CameraDescription& description() const { return m_description; }
    [[nodiscard]] core::BoundedQueue<core::CameraFrame>& frames() { return m_frames; }
    [[nodiscard]] core::DeviceStatus status() const { return m_published.get(); }

private:
    using Lock = std::unique_lock<std::mutex>;

    void waitForPlug(Lock& lock, const std::stop_token& stop);
    void begin();
    [[nodiscard]] std::int64_t due_ns(double lag_s) const;
    void makeFrame(const SimulatedFaults& faults);
    [[nodiscard]] bool happens(double share);
    void enter(core::DeviceState state, std::string message = {});
    void publish();
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }

    std::unique_ptr<core::CameraGenerator> m_generator;
    const core::StopSwitch& m_stopSwitch;
    SimulatedCameraConfig m_config;
    core::CameraDescription m_description;
    core::BoundedQueue<core::CameraFrame> m_frames;
    core::LatestCopy<core::DeviceStatus> m_published;
    core::Wakeup* m_consumer = nullptr;

    mutable std::mutex m_mutex;
    std::condition_variable m_condition;
    SimulatedFaults m_faults; ///< guarded by m_mutex

    // The worker's own.
    std::mt19937_64 m_random;
    core::RateMeter m_rate;
    core::DeviceStatus m_status;
    std::int64_t m_epoch_ns = 0;
    std::uint64_t m_sinceEpoch = 0; ///< frames since the epoch
    std::uint64_t m_number = 0;
    std::uint64_t m_lost = 0; ///< by the link or damaged
    std::uint64_t m_overflowAtOpen = 0;
    bool m_discontinuity = false;
};

} // namespace teleta::simulated
