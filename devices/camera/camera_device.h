// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/threads/device_thread.h"
#include "devices/camera/camera_worker.h"

#include <memory>

namespace teleta::camera {

/// A camera, or a video that is played like one.
///   connecting -> live; a camera that stops: lost -> reconnecting -> connecting; a file: finished; stop():
///   closed
/// Readers find out by themselves whether a live camera is stale (core::observedState).
/// Thread: as core::CameraSource; open from the controlling thread, undecodable() from any.
class CameraDevice : public core::CameraSource {
public:
    /// Error: as VideoStream::open.
    [[nodiscard]] static core::Expected<std::unique_ptr<CameraDevice>> open(CameraConfig config);

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    /// For a camera this waits until its driver delivers a frame or times out.
    void stop() override { m_thread.stop(); }
    bool pop(core::CameraFrame& frame) override { return frames().pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker.status(); }

    [[nodiscard]] core::CameraFrameQueue& frames() { return m_worker.frames(); }
    /// Frames since the start that could not be decoded; they are counted as lost, too.
    [[nodiscard]] std::uint64_t undecodable() const { return m_worker.undecodable(); }

private:
    CameraDevice(VideoStream stream, core::CameraDescription description, CameraConfig config);

    core::CameraDescription m_description;
    CameraWorker m_worker;
    core::DeviceThread<CameraWorker> m_thread{m_worker};
};

} // namespace teleta::camera
