// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/recording/stream_sink.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace teleta::foxglove {

struct LiveViewOptions {
    std::string address = "127.0.0.1"; ///< on which it listens
    std::uint16_t port = 8765;         ///< 0: any that is free
};

struct LiveViewStatus {
    enum class State { starting, listening, failed };
    State state = State::starting;
    std::string error;      ///< with failed; translated
    std::uint16_t port = 0; ///< with listening
    std::size_t clients = 0;
    std::uint64_t sent = 0;    ///< messages
    std::uint64_t dropped = 0; ///< messages and frames that came too fast for a client or for the view
};

/// Shows the streams of the running system to Foxglove while they run, from a thread of its own. Nothing that
/// a client sends changes anything. Data threads leave copies in taps and never wait; a stream whose tap
/// nobody else holds any more is over. Time is UTC by the clocks at the start. Thread: any; no call waits but
/// the destructor, for the thread to end.
class LiveView : public recording::StreamSink {
public:
    explicit LiveView(LiveViewOptions options);
    ~LiveView() override;

    [[nodiscard]] std::shared_ptr<core::StreamTap> addStream(recording::StreamInfo info) override;
    void add(recording::RecordingEvent event) override;

    [[nodiscard]] LiveViewStatus status() const { return m_status.get(); }

private:
    struct Added {
        recording::StreamInfo info;
        std::shared_ptr<core::StreamTap> tap;
    };
    class Worker;

    void run();

    LiveViewOptions m_options;
    core::LatestCopy<LiveViewStatus> m_status;
    std::atomic<bool> m_stopping{false};
    std::mutex m_mutex;
    std::vector<Added> m_added; ///< guarded by m_mutex, as the next two
    std::vector<recording::RecordingEvent> m_events;
    std::uint64_t m_eventsDropped = 0;
    std::thread m_thread;
};

} // namespace teleta::foxglove
