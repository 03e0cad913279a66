// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/urgent_thread.h"
#include "backend/playback/playback_cycle.h"
#include "backend/playback/player_types.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace teleta::playback {

/// Drives a bracelet from one playback thread: plays programs, or follows live setpoints, within the safety
/// limits. Playing always ends with a zero frame, and nothing plays again unless asked:
///   idle -> program -> idle (finished, stopped, stopSwitch, deviceLost, sourceFailed, stalled, tooHot)
///   idle -> live    -> idle (the same except finished)
/// Without a setpoint for PlayerConfig::setpointLifetime_ns all is off; live continues with the next one.
/// Thread: any. Calls return at once and take effect in the next cycle; the latest one wins. The destructor,
/// from one controlling thread, waits for the playback thread.
class Player {
public:
    /// bracelet and stopSwitch must outlive the player; the bracelet is started and stopped by its owner.
    Player(core::BraceletSource& bracelet, const core::StopSwitch& stopSwitch, PlayerConfig config = {});
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    /// Replaces what is played. Returns the number of the program, counted from 1, as in PlayerStatus.
    std::uint64_t play(Program program, bool loop = false, double from_s = 0.0);
    /// Continues with another program without a break if the one with that number is playing; otherwise does
    /// nothing. shift_s: of the position, for a program that begins elsewhere in the same pattern; a position
    /// before its start becomes its start, one after its end ends it or starts it again.
    void change(std::uint64_t number, Program program, double shift_s = 0.0);
    /// Follows setpoints from now on.
    void startLive();
    void stop();
    /// Ends the program with that number, or drops it before it begins. Anything else continues.
    void stop(std::uint64_t number);
    /// Clamped to the program. Ignored for NaN, and when no program plays.
    void seek(double time_s);
    void setLoop(bool loop);
    void setLimits(const SafetyLimits& limits);
    /// How intensities are mapped to drives of the device, from the next frame on.
    void setRanges(const DriveRanges& ranges);

    /// made_ns: steady time of what it was made from, which sets its age; a time in the future counts as now.
    /// Ignored while not live.
    void post(const core::Intensities& intensities, std::int64_t made_ns);

    [[nodiscard]] PlayerStatus status() const { return m_cycle.status(); }
    [[nodiscard]] PlayerCounters counters() const { return m_cycle.counters(); }
    [[nodiscard]] PlayerTimings timings() const { return m_cycle.timings(); }
    /// Of the playback thread.
    [[nodiscard]] core::ThreadUrgency urgency() const { return m_urgency; }
    /// Of the frames: the configured one, or the highest of the bracelet.
    [[nodiscard]] double rate_Hz() const { return m_cycle.rate_Hz(); }

private:
    template <typename Change>
    void command(const Change& change);
    void run(const std::stop_token& stop);

    std::shared_ptr<core::PacingClock> m_clock;
    PlaybackCycle m_cycle;

    std::mutex m_mutex;
    std::condition_variable m_condition;
    PlayerCommands m_commands;    ///< guarded by m_mutex
    bool m_commanded = false;     ///< guarded by m_mutex
    std::uint64_t m_programs = 0; ///< guarded by m_mutex: number of the newest one
    std::atomic<core::ThreadUrgency> m_urgency{core::ThreadUrgency::ordinary};
    bool m_takesSetpoint = false; ///< guarded by m_mutex: a setpoint ends the wait

    std::jthread m_thread;
};

} // namespace teleta::playback
