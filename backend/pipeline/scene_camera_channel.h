// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/pipeline/channel.h"
#include "backend/pipeline/scene_camera_snapshot.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace teleta::pipeline {

/// A camera that is only looked at, in the running system. Its frames are colour pictures, see
/// core::colourOf(). The newest one wins: a viewer that is late never sees an older one. A recording gets all
/// of them.
///
/// Three sides, one thread each:
/// - pipeline thread: process() takes the frames and publishes the newest;
/// - viewer (one thread, the GUI's): update(), snapshot();
/// - any thread: description(), status(), counters.
class SceneCameraChannel : public Channel {
public:
    /// source: not null.
    explicit SceneCameraChannel(std::unique_ptr<core::CameraSource> source);
    ~SceneCameraChannel() override;

    [[nodiscard]] const core::CameraDescription& description() const { return m_source->description(); }
    [[nodiscard]] ChannelSummary summary() const override;
    [[nodiscard]] core::DeviceStatus status() const override { return m_source->status(); }
    [[nodiscard]] std::uint64_t framesProcessed() const override {
        return m_processed.load(std::memory_order_relaxed);
    }
    [[nodiscard]] core::PlaybackControl* playback() override { return m_source->playback(); }

    void start(core::Wakeup& data) override { m_source->start(data); }
    void stop() override { m_source->stop(); }
    /// Takes all frames that wait; none is copied.
    std::size_t process() override;
    /// Nothing: a viewer gets the newest picture alone.
    void drain() override {}

    /// Fetches the newest snapshot; true when it changed. Viewer thread.
    bool update() { return m_snapshots.update(); }
    [[nodiscard]] const SceneCameraSnapshot& snapshot() const { return m_snapshots.front(); }
    /// 0 until the first picture has been fetched.
    [[nodiscard]] std::uint64_t generation() const { return m_snapshots.generation(); }

    /// Stream NAME-scene.
    void record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) override;
    void watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
               const std::string& name) override;

private:
    using Tap = std::shared_ptr<core::StreamTap>;
    [[nodiscard]] Tap tapInto(recording::StreamSink* sink, const std::string& name) const;

    std::unique_ptr<core::CameraSource> m_source;
    core::LatestExchange<SceneCameraSnapshot> m_snapshots;
    core::LatestCopy<Tap> m_tap;
    std::array<core::LatestCopy<Tap>, kWatchers> m_watched;
    std::atomic<std::uint64_t> m_processed{0};

    // The pipeline thread's own.
    SceneCameraSnapshot m_newest;
};

} // namespace teleta::pipeline
