// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_frame_queue.h"
#include "backend/core/device/device.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/wakeup.h"
#include "devices/camera/camera_config.h"
#include "devices/camera/video_stream.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>
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
    void wake();

    [[nodiscard]] core::CameraFrameQueue& frames() { return m_frames; }
    [[nodiscard]] core::DeviceStatus status() const { return m_published.get(); }
    [[nodiscard]] std::uint64_t undecodable() const { return m_publishedUndecodable.get(); }

private:
    /// Reads until the stream ends or stop; why it ended, empty for the end of a file.
    [[nodiscard]] std::string stream(const std::stop_token& stop);
    void reconnect(std::string reason, const std::stop_token& stop);
    void deliver(cv::Mat1b image, double capture_s);
    void waitUntil(std::int64_t deadline_ns, const std::stop_token& stop);
    void enter(core::DeviceState state, std::string message = {});
    void publish();
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }

    CameraConfig m_config;
    core::CameraFrameQueue m_frames;
    core::LatestCopy<core::DeviceStatus> m_published;
    core::LatestCopy<std::uint64_t> m_publishedUndecodable;
    core::Wakeup* m_consumer = nullptr;
    std::mutex m_mutex;
    std::condition_variable m_condition;

    // The worker's own.
    std::optional<VideoStream> m_stream;
    core::RateMeter m_rate;
    core::DeviceStatus m_status;
    std::uint64_t m_number = 0;
    std::uint64_t m_undecodable = 0;
    std::uint64_t m_skipped = 0; ///< by the connections before this one
    bool m_discontinuity = false;
};

} // namespace teleta::camera
