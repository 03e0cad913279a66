// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/threads/pacing_clock.h"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

namespace teleta::replay {

/// What somebody wants of a recording that is played.
struct PlaybackCommands {
    bool playing = true;
    bool loop = false;
    double speed = 1.0;
    std::optional<double> seek_s; ///< once
    long long steps = 0;          ///< once
    std::int64_t at_ns = 0;       ///< when the newest of it was asked for; 0: nothing was
};

/// Where the commands for a recording are left for the worker that plays it, and where that worker waits.
/// Thread: commands, wake() and describe() from any; take() and the waits from the worker's.
class PlaybackDesk {
public:
    /// speed: as setSpeed().
    PlaybackDesk(std::shared_ptr<core::PacingClock> clock, bool playing, bool loop, double speed);

    /// Changes the commands under the lock and wakes the worker.
    template <typename Change>
    void command(const Change& change) {
        const std::scoped_lock lock(m_mutex);
        change(m_commands);
        m_commands.at_ns = m_clock->now_ns();
        m_commanded = true;
        m_condition.notify_all();
    }
    /// Changes them without that: what the worker itself finds out, and before it runs.
    template <typename Change>
    void set(const Change& change) {
        const std::scoped_lock lock(m_mutex);
        change(m_commands);
    }
    void setPlaying(bool playing);
    /// factor: limited to 0.01 .. 100, or infinity: as fast as the consumer takes it. NaN changes nothing.
    void setSpeed(double factor);
    void setLoop(bool loop);
    void wake();

    /// The newest commands; what is wanted once is asked once. whileLocked: nothing can be asked meanwhile.
    template <typename Then>
    [[nodiscard]] PlaybackCommands take(const Then& whileLocked) {
        const std::scoped_lock lock(m_mutex);
        PlaybackCommands commands = m_commands;
        m_seeking_s = commands.steps == 0 ? commands.seek_s : std::nullopt;
        m_commands.seek_s.reset();
        m_commands.steps = 0;
        m_commanded = false;
        whileLocked();
        return commands;
    }
    /// Until then, a command or stop.
    void waitUntil(std::int64_t deadline_ns, const std::stop_token& stop);
    /// A moment, for room in a queue. False: stop was asked for.
    [[nodiscard]] bool waitForRoom(const std::stop_token& stop);

    /// Fills in what is commanded; the time that is sought and may not be reached yet. To be asked before the
    /// time that is shown is read.
    [[nodiscard]] std::optional<double> describe(core::PlaybackPosition& position) const;

private:
    std::shared_ptr<core::PacingClock> m_clock;
    mutable std::mutex m_mutex;
    std::condition_variable m_condition;
    PlaybackCommands m_commands;       ///< guarded by m_mutex
    bool m_commanded = false;          ///< guarded by m_mutex: there is a command that was not taken
    std::optional<double> m_seeking_s; ///< guarded by m_mutex: what was taken last and is under way
};

} // namespace teleta::replay
