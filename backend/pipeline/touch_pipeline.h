// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/scene_control.h"
#include "backend/core/error.h"
#include "backend/core/threads/wakeup.h"
#include "backend/pipeline/channel.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace teleta::pipeline {

using ChannelKey = std::uint64_t;

/// Opens a source: reads files, connects to a device. Not null. Runs on the pipeline's control thread and may
/// take its time.
using SourceFactory = std::function<core::Expected<std::shared_ptr<Channel>>()>;

/// What became of a request.
struct ChannelEvent {
    enum class Kind { opened, failed, closed };
    Kind kind = Kind::opened;
    ChannelKey key = 0;
    std::shared_ptr<Channel> channel; ///< with opened
    core::Error error;                ///< with failed
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
    void close(ChannelKey key) { request({key, {}}); }

    /// Events since the last call, in order.
    [[nodiscard]] std::vector<ChannelEvent> takeEvents();

private:
    struct Request {
        ChannelKey key = 0;
        SourceFactory factory; ///< empty: close
    };
    using Channels = std::map<ChannelKey, std::shared_ptr<Channel>>; // in the order of their opening

    void request(Request request);
    void control(const std::stop_token& stop);
    void carryOut(Request& request);
    void compute(const std::stop_token& stop);

    core::Wakeup m_data;

    std::mutex m_requestMutex;
    std::condition_variable_any m_requestCondition;
    std::vector<Request> m_requests;
    ChannelKey m_lastKey = 0;

    std::mutex m_channelMutex;
    Channels m_channels;
    std::uint64_t m_channelRevision = 0;

    std::mutex m_eventMutex;
    std::vector<ChannelEvent> m_events;

    std::jthread m_computeThread;
    std::jthread m_controlThread;
};

} // namespace teleta::pipeline
