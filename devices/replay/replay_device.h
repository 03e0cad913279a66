// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "devices/replay/replay_config.h"
#include "devices/replay/replay_worker.h"

#include <memory>
#include <thread>

namespace teleta::replay {

/// Plays recorded frames as if a device sent them.
///   connecting -> live <-> paused -> finished; a row that cannot be read: lost, with its place; stop():
///   closed
/// At a finite speed a full queue loses frames, as a device would; at infinity playing waits for the
/// consumer. A playback that is finished or lost starts over with play(), and can be searched as before.
/// Thread: start, stop and the playback control from one controlling thread; otherwise as
/// core::TactileSource.
class ReplayDevice : public core::TactileSource, public core::PlaybackControl {
public:
    /// Reads the header and the first frames, which tell the frame rate.
    /// Error: the file cannot be opened or read, has no frames, or does not fit the layout.
    [[nodiscard]] static core::Expected<std::unique_ptr<ReplayDevice>> open(ReplayConfig config);

    ~ReplayDevice() override;

    [[nodiscard]] const core::SourceDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override;
    void stop() override;
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override {
        return m_worker.outlet().blocks();
    }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker.outlet().status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return this; }

    void play() override { m_worker.play(); }
    void pause() override { m_worker.pause(); }
    void step(int frames) override { m_worker.step(frames); }
    void setSpeed(double factor) override { m_worker.setSpeed(factor); }
    /// Goes to the first frame at or after a time, or to the last frame; shows it at once, also when paused.
    void seek(double time_s) override { m_worker.seek(time_s); }
    void setLoop(bool loop) override { m_worker.setLoop(loop); }
    [[nodiscard]] core::PlaybackPosition position() const override { return m_worker.position(); }

private:
    ReplayDevice(core::SourceDescription description, ReplayCursor cursor, ReplayConfig config);

    core::SourceDescription m_description;
    ReplayWorker m_worker;
    std::jthread m_indexThread;
    core::DeviceThread m_thread;
};

} // namespace teleta::replay
