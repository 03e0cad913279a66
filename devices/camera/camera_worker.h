// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_outlet.h"
#include "backend/core/threads/worker_wait.h"
#include "devices/camera/camera_config.h"
#include "devices/camera/video_stream.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

namespace teleta::camera {

/// Reads, paces and queues frames, and opens a lost camera again.
/// Thread: run() is the worker's; wake() and status() for any; frames() for one consumer.
class CameraWorker {
public:
    CameraWorker(VideoStream stream, CameraConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_wait.wake(); }

    [[nodiscard]] core::CameraFrameQueue& frames() { return m_outlet.frames(); }
    [[nodiscard]] core::DeviceStatus status() const { return m_outlet.status(); }
    [[nodiscard]] std::uint64_t undecodable() const { return m_undecodable.load(); }

private:
    /// Reads until the stream ends or stop; why it ended, empty for the end of a file.
    [[nodiscard]] std::string stream(const std::stop_token& stop);
    void reconnect(std::string reason, const std::stop_token& stop);
    void deliver(cv::Mat1b image, double capture_s);
    [[nodiscard]] core::Expected<void> openStream();
    [[nodiscard]] std::int64_t now_ns() const { return m_wait.now_ns(); }

    CameraConfig m_config;
    core::CameraOutlet m_outlet;
    std::atomic<std::uint64_t> m_undecodable{0};
    core::WorkerWait m_wait;

    // The worker's own.
    std::optional<VideoStream> m_stream;
    std::uint64_t m_number = 0;
    bool m_discontinuity = false;
};

} // namespace teleta::camera
