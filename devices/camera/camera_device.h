// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/device_thread.h"
#include "devices/camera/camera_worker.h"

#include <memory>

namespace teleta::camera {

/// A camera, or a video that is played like one.
///   connecting -> live; a camera that stops: lost -> reconnecting -> connecting; a file: finished; stop():
///   closed
/// Whether a live camera's newest frame is stale is for the reader to see (core::observedState).
/// Thread: open, start and stop from one controlling thread; frames() drained by one consumer; status() and
/// undecodable() from any.
class CameraDevice {
public:
    /// Error: as VideoStream::open.
    [[nodiscard]] static core::Expected<std::unique_ptr<CameraDevice>> open(CameraConfig config);

    ~CameraDevice();
    CameraDevice(const CameraDevice&) = delete;
    CameraDevice& operator=(const CameraDevice&) = delete;

    /// Starts the worker, which notifies the consumer after each frame.
    void start(core::Wakeup& consumer);
    /// Ends the worker and waits for it: for a camera until its driver gives a frame or gives up. Idempotent.
    void stop();

    [[nodiscard]] core::CameraFrameQueue& frames() { return m_worker.frames(); }
    [[nodiscard]] core::DeviceStatus status() const { return m_worker.status(); }
    /// Frames since the start that could not be decoded; they are counted as lost, too.
    [[nodiscard]] std::uint64_t undecodable() const { return m_worker.undecodable(); }
    [[nodiscard]] double nominalRate_Hz() const { return m_nominalRate_Hz; }

private:
    CameraDevice(VideoStream stream, CameraConfig config);

    double m_nominalRate_Hz;
    CameraWorker m_worker;
    core::DeviceThread m_thread;
};

} // namespace teleta::camera
