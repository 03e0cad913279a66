// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_outlet.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/worker_wait.h"
#include "devices/camera/camera_config.h"
#include "devices/camera/video_stream.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace teleta::camera {

/// A camera, or a video that is played like one. A worker reads, paces and queues frames, and opens a lost
/// camera again.
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
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    [[nodiscard]] core::CameraFrameQueue& frames() { return m_outlet.frames(); }
    /// Frames since the start that could not be decoded; they are counted as lost, too.
    [[nodiscard]] std::uint64_t undecodable() const { return m_undecodable.load(); }

private:
    friend core::DeviceThread<CameraDevice>;
    CameraDevice(VideoStream stream, core::CameraDescription description, CameraConfig config);
    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_wait.wake(); }

    /// Reads until the stream ends or stop; why it ended, empty for the end of a file.
    [[nodiscard]] std::string stream(const std::stop_token& stop);
    void reconnect(std::string reason, const std::stop_token& stop);
    void deliver(cv::Mat1b image, double capture_s);
    [[nodiscard]] core::Expected<void> openStream();
    [[nodiscard]] std::int64_t now_ns() const { return m_wait.now_ns(); }

    core::CameraDescription m_description;
    CameraConfig m_config;
    core::CameraOutlet m_outlet;
    std::atomic<std::uint64_t> m_undecodable{0};
    core::WorkerWait m_wait;

    // The worker's own.
    std::optional<VideoStream> m_stream;
    std::uint64_t m_number = 0;
    bool m_discontinuity = false;

    core::DeviceThread<CameraDevice> m_thread{*this};
};

} // namespace teleta::camera
