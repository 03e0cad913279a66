// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/scene_control.h"
#include "backend/core/threads/wakeup.h"
#include "backend/recording/recording_types.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace teleta::recording {
class Recorder;
class StreamSink;
} // namespace teleta::recording

namespace teleta::pipeline {

/// Who may follow the streams of a channel beside its recorder.
enum class Watcher {
    liveView, ///< for other programs
    plot,
};
inline constexpr std::size_t kWatchers = 2;

/// What is known of every channel, whatever its source measures.
struct ChannelSummary {
    std::string name;
    double nominalRate_Hz = 0.0;
    bool simulated = false;
    bool recorded = false;
    bool guarded = true; ///< see core::ArmDescription::guarded
};

/// One open source in the running system: an array, an arm with its skin, or a camera. What runs, records or
/// reports sources knows them by this interface only; a view that shows what only one kind has asks for that
/// kind. A class rather than a variant, since the pipeline, the recorder and the status
/// bar treat all kinds alike, and a further kind of source then changes none of them.
///
/// Threads: start() and stop() by the control thread; process() by the pipeline thread; drain(), record(),
/// watch() and takeSettingsEvent() by the viewer (the GUI's); the rest by any.
class Channel {
public:
    virtual ~Channel() = default;
    Channel() = default;
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    [[nodiscard]] virtual ChannelSummary summary() const = 0;
    /// Of what the views show first: of an arm, its skin.
    [[nodiscard]] virtual core::DeviceStatus status() const = 0;
    [[nodiscard]] virtual std::uint64_t framesProcessed() const = 0;
    /// Null unless a recording is played.
    [[nodiscard]] virtual core::PlaybackControl* playback() = 0;

    /// data: is notified of what there is to process.
    virtual void start(core::Wakeup& data) = 0;
    /// Waits for the threads of the source. Idempotent.
    virtual void stop() = 0;
    /// Processes what waits when it is called. Returns the number of frames, of an arm that of joint samples.
    virtual std::size_t process() = 0;

    /// Drops what waits for a viewer: nobody looks, and it is not shown later as if it were new.
    virtual void drain() = 0;

    /// Records what comes from now on as streams that begin with a name; a null recorder: no more.
    virtual void record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) = 0;
    /// Somebody else follows the same streams, whether it is recorded or not; null: no more.
    virtual void watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
                       const std::string& name) = 0;
    /// The settings, when they have changed since record() or the last call.
    [[nodiscard]] virtual std::optional<recording::RecordingEvent> takeSettingsEvent() {
        return std::nullopt;
    }

    /// It moves by a program that can be held and begun anew.
    [[nodiscard]] virtual bool hasProgram() const { return m_scene != nullptr; }
    /// A simulated scene stands still until somebody lets it run.
    [[nodiscard]] bool isSceneHeld() const { return m_scene != nullptr && m_scene->isHeld(); }
    virtual void setProgramRunning(bool running) {
        if (m_scene)
            m_scene->setRunning(running);
    }
    virtual void restartProgram() {
        if (m_scene)
            m_scene->restart();
    }
    /// Of a simulated scene that can be held. Before start().
    void setScene(std::shared_ptr<core::SceneControl> scene) { m_scene = std::move(scene); }

private:
    std::shared_ptr<core::SceneControl> m_scene;
};

} // namespace teleta::pipeline
