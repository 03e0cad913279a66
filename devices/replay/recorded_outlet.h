// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_frame_queue.h"
#include "backend/core/device/device.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/threads/latest_copy.h"
#include "devices/replay/recorded_track.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace teleta::replay {

/// When a frame of a recording is played.
struct PlayedFrame {
    std::int64_t time_ns = 0;       ///< when it is due
    double sourceTime_s = 0.0;      ///< since the recording's start
    bool jumped = false;            ///< it does not go on from the one before
    core::GreyImage reference = {}; ///< of a picture: as CameraFrame's
};

/// Where a worker leaves the frames of the stream that it plays: taken one by one, then delivered together.
/// Thread: status() is for any, the rest for the worker.
class RecordedOutlet {
public:
    virtual ~RecordedOutlet() = default;
    RecordedOutlet() = default;
    RecordedOutlet(const RecordedOutlet&) = delete;
    RecordedOutlet& operator=(const RecordedOutlet&) = delete;

    /// Counters start at 0, the state is connecting. Before the worker runs.
    virtual void open(core::Wakeup& consumer, std::int64_t now_ns) = 0;
    /// Takes the frame that a track is at.
    virtual void take(const RecordedTrack& track, const PlayedFrame& frame) = 0;
    [[nodiscard]] virtual std::size_t taken() const = 0;
    /// As many were taken as go together.
    [[nodiscard]] virtual bool isFull() const = 0;
    /// Hands on what was taken, at least one frame, and tells this state. canWait: false is returned when
    /// there is no room, and then nothing happened; otherwise frames are lost and counted.
    [[nodiscard]] virtual bool deliver(core::DeviceState state, bool canWait) = 0;

    virtual void setState(core::DeviceState state, std::int64_t now_ns, std::string message = {}) = 0;
    [[nodiscard]] virtual core::DeviceState state() const = 0;
    [[nodiscard]] virtual core::DeviceStatus status() const = 0;
};

/// For an array.
class RecordedArrayOutlet : public RecordedOutlet {
public:
    explicit RecordedArrayOutlet(std::size_t queueBlocks)
        : m_outlet(queueBlocks) {}

    void open(core::Wakeup& consumer, std::int64_t now_ns) override;
    void take(const RecordedTrack& track, const PlayedFrame& frame) override;
    [[nodiscard]] std::size_t taken() const override { return m_block.frames(); }
    [[nodiscard]] bool isFull() const override;
    [[nodiscard]] bool deliver(core::DeviceState state, bool canWait) override;
    void setState(core::DeviceState state, std::int64_t now_ns, std::string message) override {
        m_outlet.setState(state, now_ns, std::move(message));
    }
    [[nodiscard]] core::DeviceState state() const override { return m_outlet.state(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() { return m_outlet.blocks(); }

private:
    core::SourceOutlet m_outlet;
    core::SampleBlock m_block;
};

/// For a camera: one picture at a time.
class RecordedCameraOutlet : public RecordedOutlet {
public:
    explicit RecordedCameraOutlet(std::size_t queueFrames)
        : m_frames(queueFrames) {}

    void open(core::Wakeup& consumer, std::int64_t now_ns) override;
    void take(const RecordedTrack& track, const PlayedFrame& frame) override;
    [[nodiscard]] std::size_t taken() const override { return m_picture.image.isEmpty() ? 0 : 1; }
    [[nodiscard]] bool isFull() const override { return taken() > 0; }
    [[nodiscard]] bool deliver(core::DeviceState state, bool canWait) override;
    void setState(core::DeviceState state, std::int64_t now_ns, std::string message) override;
    [[nodiscard]] core::DeviceState state() const override { return m_status.state; }
    [[nodiscard]] core::DeviceStatus status() const override { return m_published.get(); }

    /// Drained by one consumer.
    [[nodiscard]] core::CameraFrameQueue& frames() { return m_frames; }

private:
    void publish();

    core::CameraFrameQueue m_frames;
    core::CameraFrame m_picture;
    core::RateMeter m_rate;
    core::DeviceStatus m_status;
    core::LatestCopy<core::DeviceStatus> m_published;
    core::Wakeup* m_consumer = nullptr;
};

} // namespace teleta::replay
