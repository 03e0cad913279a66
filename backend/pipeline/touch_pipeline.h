// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/scene_control.h"
#include "backend/core/error.h"
#include "backend/core/threads/wakeup.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/servo/servo_link.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace teleta::pipeline {

class CameraChannel;

using ChannelKey = std::uint64_t;

/// A source that was opened, with the settings that its frames start with. With an arm, the source is the
/// arm's skin. A camera is none of these: it has its channel, and no source.
struct OpenedSource {
    std::unique_ptr<core::TactileSource> source;
    ChannelSettings settings;
    std::unique_ptr<core::ArmSource> arm = nullptr; ///< null for an array on its own
    ArmSettings armSettings = {};
    std::shared_ptr<servo::ServoLink> servo = nullptr; ///< of the servo that moves the array; null: none
    std::shared_ptr<CameraChannel> camera = nullptr;   ///< null unless the source is a camera
    /// Of a simulated scene without an arm of its own program; null: nobody can hold it.
    std::shared_ptr<core::SceneControl> scene = nullptr;
};

/// Opens a source: reads files, connects to a device. Runs on the pipeline's control thread and may take its
/// time.
using SourceFactory = std::function<core::Expected<OpenedSource>()>;

/// What became of a request.
struct ChannelEvent {
    enum class Kind { opened, failed, closed };
    Kind kind = Kind::opened;
    ChannelKey key = 0;
    std::shared_ptr<TouchChannel> channel;     ///< with opened, unless it is a camera
    std::shared_ptr<ArmChannel> arm;           ///< with opened, when the source is the skin of an arm
    std::shared_ptr<servo::ServoLink> servo;   ///< with opened, when a servo moves the array
    std::shared_ptr<CameraChannel> camera;     ///< with opened, when the source is a camera
    std::shared_ptr<core::SceneControl> scene; ///< with opened, when the source is a scene that can be held
    core::Error error;                         ///< with failed
};

/// The running system: opens and closes sources on a control thread, processes what they deliver on one
/// pipeline thread; a camera has a thread of its own. No call waits for a device; what became of a request
/// comes back as an event. Thread: open, close and takeEvents from one controlling thread (the GUI's).
class TouchPipeline {
public:
    TouchPipeline();
    /// Closes all channels and waits for the threads.
    ~TouchPipeline();
    TouchPipeline(const TouchPipeline&) = delete;
    TouchPipeline& operator=(const TouchPipeline&) = delete;

    /// Asks for a source to be opened; returns the key under which its events come.
    ChannelKey open(SourceFactory factory);
    void close(ChannelKey key);

    /// Events since the last call, in order.
    [[nodiscard]] std::vector<ChannelEvent> takeEvents();

    /// Waits until all requests made so far have been carried out. For the command line and for tests.
    void waitUntilIdle();

private:
    struct Request {
        ChannelKey key = 0;
        SourceFactory factory; ///< empty: close
    };
    struct Entry {
        ChannelKey key = 0;
        std::shared_ptr<TouchChannel> channel;
        std::shared_ptr<ArmChannel> arm;       ///< null for an array on its own
        std::shared_ptr<CameraChannel> camera; ///< alone

        void start(core::Wakeup& data) const;
        void stop() const;
        void process() const;
    };

    void control(const std::stop_token& stop);
    void carryOut(Request& request);
    void compute(const std::stop_token& stop);

    core::Wakeup m_data;

    std::mutex m_requestMutex;
    std::condition_variable_any m_requestCondition;
    std::condition_variable m_idleCondition;
    std::vector<Request> m_requests;
    bool m_busy = false;
    ChannelKey m_lastKey = 0;

    std::mutex m_channelMutex;
    std::vector<Entry> m_channels;
    std::uint64_t m_channelRevision = 0;

    std::mutex m_eventMutex;
    std::vector<ChannelEvent> m_events;

    std::jthread m_computeThread;
    std::jthread m_controlThread;
};

} // namespace teleta::pipeline
