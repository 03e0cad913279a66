// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/bracelet/tactors.h"
#include "backend/core/threads/pacing_clock.h"
#include "backend/playback/heat_memory.h"
#include "backend/playback/safety_limiter.h"
#include "backend/playback/time_histogram.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace teleta::playback {

/// Something that can be played. evaluate is called on the playback thread with times from 0 to duration_s;
/// it must be fast. An exception from it ends the playing.
struct Program {
    std::function<core::Intensities(double t_s)> evaluate;
    double duration_s = 0.0; ///< infinity: without an end
    bool raw = false;        ///< what it gives are drives of the device, not mapped by the motors' ranges
};

struct PlayerConfig {
    /// Of the frames: at least 20, at most what the bracelet can take. One that cannot take 20 misses
    /// deadlines.
    double rate_Hz = 200.0;
    /// Lifetime of a live setpoint.
    std::int64_t setpointLifetime_ns = 100'000'000;
    /// Time without a frame after which the board stops by itself: at least three periods, at most the
    /// board's own limit. A cycle that is later than this ends the playing, since the bracelet has stood
    /// still.
    std::uint16_t boardTimeout_ms = 100;
    /// A bracelet that answers no frame for this long counts as lost: its frames are queued somewhere and
    /// would play when it wakes.
    std::int64_t longestSilence_ns = 1'000'000'000;
    SafetyLimits limits{};
    DriveRanges ranges{};
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
    /// Shared by players with copies of this, each of which continues from the heat of its bracelet. Null:
    /// motors begin cold.
    std::shared_ptr<HeatMemory> heat = std::make_shared<HeatMemory>();
};

enum class PlayerMode {
    idle,    ///< the bracelet was told to be off
    program, ///< a program is played
    live,    ///< setpoints are followed
};

/// Why the last playback ended.
enum class PlayerEnding {
    none,         ///< nothing was played yet, or something is
    finished,     ///< the program came to its end
    stopped,      ///< stop() or the end of the player
    stopSwitch,   ///< STOP is, or was, engaged
    deviceLost,   ///< there is no bracelet, it was unplugged, or it no longer answers
    sourceFailed, ///< the program threw an exception; PlayerStatus::message has its text
    stalled,      ///< a cycle was later than the board's time-out, or the program, a write or the machine's
                  ///< sleep took longer
    tooHot,       ///< the board reports that it is too hot; nothing is played until it has cooled down
};

struct PlayerStatus {
    PlayerMode mode = PlayerMode::idle;
    PlayerEnding ending = PlayerEnding::none;
    std::string message;       ///< with sourceFailed: text of the exception, not translated
    std::int64_t begun_ns = 0; ///< steady time at which the playing began; identifies it
    std::int64_t ended_ns = 0; ///< steady time of the zero frame that ended it; 0 while it runs
    std::uint64_t program = 0; ///< number of the newest program that began, see Player::play
    std::uint64_t settled = 0; ///< number of the newest program that began or was dropped before it could
    double position_s = 0.0;   ///< in the program, of the newest frame
    double duration_s = 0.0;   ///< of the program
    bool loop = false;         ///< the program starts again at its end
    bool silent = false;       ///< live, but the last setpoint is too old: all is off
    core::Intensities given{}; ///< after the safety limits
};

/// Of the current playback, or of the last one.
struct PlayerCounters {
    std::uint64_t framesWritten = 0;
    std::uint64_t deadlineMisses = 0;    ///< deadlines that passed without a frame of their own
    std::uint64_t framesLost = 0;        ///< not confirmed by the board
    std::uint64_t framesRefused = 0;     ///< lost ones that the board did not understand
    bool confirmed = false;              ///< the board confirmed a frame of this playing and refused none
    std::uint64_t watchdogTrips = 0;     ///< times that no setpoint came
    std::uint64_t setpointsReplaced = 0; ///< by a newer one before a frame took them
    double rate_Hz = 0.0;                ///< achieved
    std::int64_t writeMedian_ns = 0;
    std::int64_t writeLongest_ns = 0;
    std::int64_t latencyMedian_ns = 0; ///< from the making of a setpoint to its first frame written
    std::int64_t latencyLongest_ns = 0;
    std::int64_t begun_ns = 0;      ///< steady time at which the playing began
    std::int64_t firstFrame_ns = 0; ///< steady time at which the first frame was written; 0: none
    std::int64_t onset_ns = 0; ///< steady time at which the first frame other than zero was written; 0: none
};

/// Punctuality of the current playback, or of the last one.
struct PlayerTimings {
    TimeHistogram lateness; ///< of regular frames: from the deadline to the begin of the frame's work
    TimeHistogram write;    ///< of a frame
    TimeHistogram latency;  ///< from the making of a setpoint to its first frame written
};

struct Setpoint {
    core::Intensities intensities{};
    std::int64_t made_ns = 0; ///< steady time of what it was made from
};

struct ProgramRequest {
    Program program;
    bool loop = false;
    double from_s = 0.0;
    std::uint64_t number = 0;
};
/// Another program in place of the one with that number, while it plays.
struct ProgramChange {
    Program program;
    double shift_s = 0.0; ///< of the position
    std::uint64_t number = 0;
};
struct LiveRequest {};

/// Requests since the last cycle, carried out in the order of the members.
struct PlayerCommands {
    bool stop = false;
    std::optional<std::uint64_t> stopProgram; ///< the program with that number ends, nothing else
    std::optional<SafetyLimits> limits;
    std::optional<DriveRanges> ranges;
    std::optional<std::variant<ProgramRequest, LiveRequest>> start;
    std::optional<ProgramChange> change;
    std::optional<bool> loop;
    std::optional<double> seek_s;
    std::uint64_t newest = 0; ///< number of the newest program that was asked for, dropped ones too

    /// Takes back what was asked for before another start or a stop.
    void dropChanges() {
        change.reset();
        loop.reset();
        seek_s.reset();
    }
};

} // namespace teleta::playback
