// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/rate_meter.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/mailbox.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/playback/player_types.h"
#include "backend/playback/safety_limiter.h"

#include <cstdint>
#include <mutex>
#include <string>

namespace teleta::playback {

/// The work of the playback thread, one call per cycle:
///   STOP -> commands -> frame if one is due -> time of the next deadline, t0 + k dt
/// A late frame is evaluated at the true time; missed deadlines are counted, not made up for. A live setpoint
/// does not wait for the next deadline: one frame a period is written for it out of turn.
/// Thread: run() and close() from one; setpoint box, status() and counters() by any.
class PlaybackCycle {
public:
    /// bracelet and stopSwitch must outlive the cycle.
    PlaybackCycle(core::BraceletSource& bracelet, const core::StopSwitch& stopSwitch, PlayerConfig config);

    /// Does what is due. Returns the time of the next call; PacingClock::kNever_ns: when a command comes.
    [[nodiscard]] std::int64_t run(PlayerCommands commands);
    /// Ends the playback.
    void close();

    [[nodiscard]] core::Mailbox<Setpoint>& setpoints() { return m_setpoints; }
    /// A setpoint that comes now would be written before the next deadline. Thread: that of run().
    [[nodiscard]] bool takesSetpointAtOnce() const { return m_mode == PlayerMode::live && !m_extraWritten; }

    [[nodiscard]] PlayerStatus status() const { return m_published.get(); }
    [[nodiscard]] PlayerCounters counters() const;
    [[nodiscard]] PlayerTimings timings() const;
    [[nodiscard]] double rate_Hz() const { return m_rate_Hz; }

private:
    void takeSettings(const PlayerCommands& commands);
    void begin(ProgramRequest request);
    void begin(LiveRequest);
    void beginAny(PlayerMode mode);
    void change(ProgramChange change);
    void moveTo(double position_s, std::int64_t now_ns);
    void end(PlayerEnding ending, std::string message = {});

    [[nodiscard]] bool takeSetpoint();
    void writeDue(std::int64_t now_ns);
    [[nodiscard]] bool evaluate(std::int64_t now_ns, core::Intensities& wanted);
    [[nodiscard]] bool programAt(std::int64_t now_ns, core::Intensities& wanted);
    void liveAt(std::int64_t now_ns, core::Intensities& wanted);
    void account(const core::Drive& drive, std::int64_t begun_ns, std::int64_t written_ns);
    void schedule(bool regular, std::int64_t now_ns);
    void countMisses(std::int64_t first, std::int64_t next);
    [[nodiscard]] std::int64_t firstDeadlineAfter(std::int64_t now_ns) const;
    [[nodiscard]] double programPosition_s(std::int64_t time_ns) const;
    [[nodiscard]] double sinceLastFrame_s(std::int64_t now_ns);
    [[nodiscard]] std::int64_t deadline_ns(std::int64_t cycle) const;
    [[nodiscard]] std::int64_t boardTimeout_ns() const {
        return std::int64_t{m_config.boardTimeout_ms} * 1'000'000;
    }
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }
    void publish();

    core::BraceletSource& m_bracelet;
    const core::StopSwitch& m_stopSwitch;
    PlayerConfig m_config;
    double m_rate_Hz;
    SafetyLimiter m_limiter;
    core::Mailbox<Setpoint> m_setpoints;

    PlayerMode m_mode = PlayerMode::idle;
    std::uint64_t m_connection = 0;  ///< of the bracelet, at the begin
    std::int64_t m_suspended_ns = 0; ///< how long the machine had slept at the begin
    std::int64_t m_epoch_ns = 0;     ///< t0
    std::int64_t m_cycle = 0;        ///< k of the next deadline
    bool m_extraWritten = false;     ///< a setpoint had its frame out of turn in this period
    std::int64_t m_lastFrame_ns = 0;

    Program m_program;
    std::int64_t m_anchor_ns = 0;
    double m_anchorPosition_s = 0.0;

    Setpoint m_setpoint;
    bool m_anySetpoint = false;
    bool m_freshSetpoint = false; ///< no frame has it yet

    PlayerStatus m_status;
    core::LatestCopy<PlayerStatus> m_published;

    mutable std::mutex m_countersMutex; ///< of what follows
    PlayerCounters m_counters;
    PlayerTimings m_timings;
    core::RateMeter m_rate;
    std::uint64_t m_lostBefore = 0;
    std::uint64_t m_refusedBefore = 0;
    std::uint64_t m_sentBefore = 0; ///< number of the last frame before the playing
    std::uint64_t m_replacedBefore = 0;
};

} // namespace teleta::playback
