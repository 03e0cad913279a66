// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_outlet.h"
#include "backend/core/device/chip_thermometers.h"
#include "backend/core/device/joint_outlet.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/interface.h"
#include "devices/replay/playback_recording.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace teleta::replay {

/// How a frame of a recording is played.
struct PlayedFrame {
    std::int64_t time_ns = 0;       ///< when it is due
    bool jumped = false;            ///< it does not follow the frame before it
    core::GreyImage reference = {}; ///< of a picture: as CameraFrame's
};

/// Where a worker leaves the frames that it plays: taken one by one, then delivered together.
/// Thread: status() from any; the rest from the worker's.
class PlaybackOutlet : public core::Interface {
public:
    /// Counters start at 0, the state is connecting. Before the worker runs.
    virtual void open(core::Wakeup& consumer, std::int64_t now_ns) = 0;
    /// Takes the frame at which a track stands.
    virtual void take(const PlaybackTrack& track, const PlayedFrame& frame) = 0;
    [[nodiscard]] virtual std::size_t taken() const = 0;
    /// What was taken has to be delivered before more is taken.
    [[nodiscard]] virtual bool isFull() const = 0;
    /// Delivers what was taken, at least one frame, and enters a state. With canWait, returns false and
    /// changes nothing when there is no room; without, frames are lost and counted then.
    [[nodiscard]] virtual bool deliver(core::DeviceState state, bool canWait) = 0;

    virtual void setState(core::DeviceState state, std::int64_t now_ns, std::string message = {}) = 0;
    [[nodiscard]] virtual core::DeviceState state() const = 0;
    [[nodiscard]] virtual core::DeviceStatus status() const = 0;
};

/// Forwards state and status to a SourceOutlet or a CameraOutlet.
template <typename Outlet>
class PlaybackOutletOn : public PlaybackOutlet {
public:
    explicit PlaybackOutletOn(std::size_t queueSize)
        : m_outlet(queueSize) {}

    void setState(core::DeviceState state, std::int64_t now_ns, std::string message) override {
        m_outlet.setState(state, now_ns, std::move(message));
    }
    [[nodiscard]] core::DeviceState state() const override { return m_outlet.state(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

protected:
    Outlet m_outlet;
};

/// For an array: blocks of frames.
class ArrayPlaybackOutlet : public PlaybackOutletOn<core::SourceOutlet> {
public:
    using PlaybackOutletOn::PlaybackOutletOn;

    void open(core::Wakeup& consumer, std::int64_t now_ns) override;
    void take(const PlaybackTrack& track, const PlayedFrame& frame) override;
    [[nodiscard]] std::size_t taken() const override { return m_block.frames(); }
    [[nodiscard]] bool isFull() const override;
    [[nodiscard]] bool deliver(core::DeviceState state, bool canWait) override;

    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() { return m_outlet.blocks(); }

private:
    core::SampleBlock m_block;
};

/// For a camera: one picture at a time.
class CameraPlaybackOutlet : public PlaybackOutletOn<core::CameraOutlet> {
public:
    using PlaybackOutletOn::PlaybackOutletOn;

    void open(core::Wakeup& consumer, std::int64_t now_ns) override;
    void take(const PlaybackTrack& track, const PlayedFrame& frame) override;
    [[nodiscard]] std::size_t taken() const override { return m_picture.image.isEmpty() ? 0 : 1; }
    [[nodiscard]] bool isFull() const override { return taken() > 0; }
    [[nodiscard]] bool deliver(core::DeviceState state, bool canWait) override;

    /// Drained by one consumer.
    [[nodiscard]] core::CameraFrameQueue& frames() { return m_outlet.frames(); }

private:
    core::CameraFrame m_picture;
};

/// For an arm without an array: joint samples.
class JointPlaybackOutlet : public PlaybackOutlet {
public:
    explicit JointPlaybackOutlet(std::size_t queueSamples);

    void open(core::Wakeup& consumer, std::int64_t now_ns) override;
    void take(const PlaybackTrack& track, const PlayedFrame& frame) override;
    [[nodiscard]] std::size_t taken() const override { return m_taken.size(); }
    [[nodiscard]] bool isFull() const override;
    [[nodiscard]] bool deliver(core::DeviceState state, bool canWait) override;

    void setState(core::DeviceState state, std::int64_t now_ns, std::string message) override {
        m_outlet.setState(state, now_ns, std::move(message));
    }
    [[nodiscard]] core::DeviceState state() const override { return m_outlet.state(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    /// Drained by one consumer.
    [[nodiscard]] core::BoundedQueue<core::JointSample>& samples() { return m_outlet.samples(); }

private:
    core::JointOutlet m_outlet;
    std::vector<core::JointSample> m_taken;
};

/// The joint sample at which a track stands.
[[nodiscard]] core::JointSample jointSampleAt(const PlaybackTrack& track, const PlayedFrame& frame);
/// The force and torque at which a track stands. time_ns: when it was due.
[[nodiscard]] core::WrenchSample wrenchSampleAt(const PlaybackTrack& track, std::int64_t time_ns);
/// The temperatures at which a track stands.
[[nodiscard]] core::TemperatureSample temperatureSampleAt(const PlaybackTrack& track,
                                                          const PlayedFrame& frame);

} // namespace teleta::replay
