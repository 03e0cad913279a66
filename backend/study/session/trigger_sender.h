// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/trigger_port.h"
#include "backend/core/steady_time.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace teleta::study {

/// What a trigger line does.
struct TriggerStatus {
    enum class State { opening, open, failed };
    State state = State::opening;
    std::optional<core::Error> error = {}; ///< the last one; stays after the line has come back
    std::uint64_t written = 0;
    std::uint64_t failures = 0; ///< events that could not be written
};

/// Writes triggers from a thread of its own, so that no device holds a session. The thread opens the line,
/// and opens it again, at most once a second, after a failure; events meanwhile are counted as failed and not
/// sent late, since a late trigger is a wrong one.
/// Thread: one caller; the calls return at once, but the destructor waits for the thread.
class TriggerSender {
public:
    using Opener = std::function<core::Expected<std::unique_ptr<core::TriggerPort>>()>;
    /// Time of the confirmed onset; 0: not yet. Called from the sender's thread, many times.
    using Onset = std::function<std::int64_t()>;

    explicit TriggerSender(Opener opener);
    ~TriggerSender();
    TriggerSender(const TriggerSender&) = delete;
    TriggerSender& operator=(const TriggerSender&) = delete;

    void post(core::TriggerEvent event);

    /// Posts an event, with its time, as soon as onset() knows one. Replaces one that still waits. onset is
    /// destroyed on the caller's thread, by the next await() or forget() or with the sender.
    void await(core::TriggerEvent event, Onset onset);
    /// The event that waits is not posted any more; does nothing when it was.
    void forget();
    /// Milliseconds from the onset until the write of the last awaited event had returned; empty: it was not
    /// written.
    [[nodiscard]] std::optional<double> onsetToWritten_ms() const;

    [[nodiscard]] TriggerStatus status() const;

private:
    struct Waiting {
        core::TriggerEvent event;
        Onset onset;
    };

    void run(const std::stop_token& stop);
    [[nodiscard]] bool look();
    void openLine(std::unique_lock<std::mutex>& lock);
    void write(std::unique_lock<std::mutex>& lock);
    void clear(std::unique_lock<std::mutex>& lock);
    void lose(const core::Error& error);

    Opener m_opener;
    mutable std::mutex m_mutex; ///< of what follows, but for the port
    std::condition_variable_any m_condition;
    std::deque<std::pair<core::TriggerEvent, bool>> m_queue; ///< bool: it was awaited
    std::optional<Waiting> m_waiting;
    bool m_isWatching = false; ///< m_waiting has an onset to be watched
    std::optional<double> m_onsetToWritten_ms;
    TriggerStatus m_status;

    std::unique_ptr<core::TriggerPort> m_port; ///< of the thread
    std::int64_t m_clearAt_ns = 0;             ///< 0: nothing to be cleared
    std::int64_t m_openAt_ns = 0;
    std::jthread m_thread; ///< last, so that it ends first
};

} // namespace teleta::study
