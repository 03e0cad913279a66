// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_frame_queue.h"
#include "backend/core/device/status_publisher.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace teleta::core {

/// The worker's end of a camera, as SourceOutlet is for an array: queues frames, publishes the status and
/// wakes the consumer.
/// Thread: frames() is drained by one consumer, status() from any; the rest from the worker's.
class CameraOutlet {
public:
    explicit CameraOutlet(std::size_t queueFrames)
        : m_frames(queueFrames) {}

    /// Starts a stream. Before the worker runs.
    void open(Wakeup& consumer, std::int64_t now_ns) { m_status.open(consumer, now_ns); }
    /// Queues a frame that was read at its time_ns; a full queue drops its oldest frame.
    void deliver(CameraFrame&& frame, DeviceState state = DeviceState::live) {
        m_status.receive(state, frame.time_ns);
        m_frames.push(std::move(frame));
        m_status.publishAndWake();
    }
    /// Counts frames that the device or its link lost.
    void lose(std::uint64_t frames) {
        m_status.lose(frames);
        m_status.publishAndWake();
    }
    void setState(DeviceState state, std::int64_t now_ns, std::string message = {}) {
        m_status.setState(state, now_ns, std::move(message));
    }

    [[nodiscard]] bool isFull() const { return m_frames.size() >= m_frames.capacity(); }
    [[nodiscard]] DeviceState state() const { return m_status.state(); }
    [[nodiscard]] std::uint64_t framesRead() const { return m_status.current().framesRead; }
    [[nodiscard]] DeviceStatus status() const { return m_status.status(); }
    [[nodiscard]] CameraFrameQueue& frames() { return m_frames; }

private:
    CameraFrameQueue m_frames;
    StatusPublisher m_status;
};

} // namespace teleta::core
