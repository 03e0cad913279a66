// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/threads/pacing_clock.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

namespace teleta::replay {

/// What somebody wants of a playback.
struct PlaybackCommands {
    bool playing = true;
    bool loop = false;
    double speed = 1.0;
    std::optional<double> seek_s; ///< once
    long long steps = 0;          ///< once
    std::int64_t at_ns = 0;       ///< when the newest command was given; 0: none was
};

/// Commands for a playback on their way to its worker, and the worker's waits, which they end.
/// Thread: commands, wake(), isSeekWaiting() and describe() from any; the rest from the worker's.
class PlaybackCommandBox {
public:
    /// speed: as setSpeed().
    PlaybackCommandBox(std::shared_ptr<core::PacingClock> clock, bool playing, bool loop, double speed);

    void setPlaying(bool playing);
    /// Moves by this many frames (negative: back) and pauses.
    void step(int frames);
    /// factor: limited to 0.01 .. 100, or infinity: as fast as the consumer takes the frames. NaN is ignored.
    void setSpeed(double factor);
    /// time_s: below 0 counts as 0. NaN is ignored.
    void seek(double time_s);
    void setLoop(bool loop);
    void wake();

    /// Before the worker runs: goes to the beginning, and plays or waits there.
    void begin(bool playing);
    /// What the worker found out: the playback is at its end.
    void end();

    /// The newest commands. Seeks and steps are handed out once.
    [[nodiscard]] PlaybackCommands take();
    /// A seek was asked for since take().
    [[nodiscard]] bool isSeekWaiting() const { return m_seekWaiting.load(std::memory_order_relaxed); }
    /// Waits until then, or for a command or stop.
    void waitUntil(std::int64_t deadline_ns, const std::stop_token& stop);
    /// Waits a moment for room in a queue. False: stop was requested.
    [[nodiscard]] bool waitForRoom(const std::stop_token& stop);

    /// Fills in what is commanded. Returns the time of a seek that was not carried out yet. To be called
    /// before the time that is shown is read.
    [[nodiscard]] std::optional<double> describe(core::PlaybackPosition& position) const;

private:
    template <typename Change>
    void command(const Change& change);

    std::shared_ptr<core::PacingClock> m_clock;
    mutable std::mutex m_mutex; ///< of what follows
    std::condition_variable m_condition;
    PlaybackCommands m_commands;
    bool m_commanded = false;          ///< there is a command that was not taken
    std::optional<double> m_seeking_s; ///< taken last and being carried out
    std::atomic<bool> m_seekWaiting{false};
};

} // namespace teleta::replay
