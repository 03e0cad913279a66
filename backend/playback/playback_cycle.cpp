// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/playback_cycle.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

namespace teleta::playback {

namespace {

constexpr double kNsPerS = 1e9;
/// Below it the watchdogs would take the time between two frames for a standstill.
constexpr double kLowestRate_Hz = 20.0;

double usableRate_Hz(double wanted_Hz, double most_Hz) {
    const double rate_Hz = std::min(wanted_Hz, most_Hz);
    return rate_Hz > kLowestRate_Hz ? rate_Hz : kLowestRate_Hz;
}

} // namespace

PlaybackCycle::PlaybackCycle(core::BraceletSource& bracelet, const core::StopSwitch& stopSwitch,
                             PlayerConfig config)
    : m_bracelet(bracelet)
    , m_stopSwitch(stopSwitch)
    , m_config(std::move(config))
    , m_rate_Hz(usableRate_Hz(m_config.rate_Hz, bracelet.description().maximumRate_Hz))
    , m_limiter(m_config.limits, 1.0 / m_rate_Hz)
    , m_lastFrame_ns(now_ns()) {
    if (m_config.heat)
        if (const auto kept = m_config.heat->of(m_bracelet.description().serial))
            m_limiter.resume(kept->heat, static_cast<double>(m_lastFrame_ns - kept->time_ns) / kNsPerS);
    const double threePeriods_ms = std::ceil(3e3 / m_rate_Hz);
    m_config.boardTimeout_ms =
        std::max(m_config.boardTimeout_ms, static_cast<std::uint16_t>(threePeriods_ms));
    // A board that waits less stands still sooner.
    m_config.boardTimeout_ms = std::clamp<std::uint16_t>(
        m_config.boardTimeout_ms, 1, std::max<std::uint16_t>(bracelet.description().longestTimeout_ms, 1));
}

std::int64_t PlaybackCycle::run(PlayerCommands commands) {
    const std::uint64_t settledBefore = m_status.settled;
    m_status.settled = std::max(m_status.settled, commands.newest);
    if (m_stopSwitch.engaged()) {
        if (m_mode != PlayerMode::idle || commands.start)
            end(PlayerEnding::stopSwitch);
        else if (m_status.settled != settledBefore)
            publish();
        takeSettings(commands);
        return core::PacingClock::kNever_ns;
    }
    const bool stopsProgram = m_mode == PlayerMode::program && commands.stopProgram == m_status.program;
    if ((commands.stop && m_mode != PlayerMode::idle) || stopsProgram)
        end(PlayerEnding::stopped);
    takeSettings(commands);
    if (commands.start)
        std::visit([this](auto& request) { begin(std::move(request)); }, *commands.start);
    else if (m_status.settled != settledBefore)
        publish();
    if (commands.change)
        change(std::move(*commands.change));
    if (commands.loop)
        m_status.loop = *commands.loop;
    if (commands.seek_s)
        moveTo(*commands.seek_s, now_ns());
    if (m_mode == PlayerMode::idle)
        return core::PacingClock::kNever_ns;

    const bool outOfTurn = takeSetpoint() && !m_extraWritten;
    const std::int64_t now = now_ns();
    if (outOfTurn || now >= deadline_ns(m_cycle))
        writeDue(now);
    return m_mode == PlayerMode::idle ? core::PacingClock::kNever_ns : deadline_ns(m_cycle);
}

void PlaybackCycle::takeSettings(const PlayerCommands& commands) {
    if (commands.limits)
        m_limiter.setLimits(*commands.limits);
    if (commands.ranges)
        m_config.ranges = *commands.ranges;
}

void PlaybackCycle::close() {
    if (m_mode != PlayerMode::idle)
        end(PlayerEnding::stopped);
}

PlayerCounters PlaybackCycle::counters() const {
    const core::BraceletTelemetry telemetry = m_bracelet.telemetry();
    // A bracelet that was started again counts from 0.
    const auto since = [](std::uint64_t now, std::uint64_t before) {
        return now >= before ? now - before : now;
    };
    const std::scoped_lock lock(m_countersMutex);
    PlayerCounters counters = m_counters;
    counters.framesLost = since(telemetry.framesLost, m_lostBefore);
    counters.framesRefused = since(telemetry.framesRefused, m_refusedBefore);
    // A board that refuses driving frames still understands the zero frame at the end.
    counters.confirmed = telemetry.newestEchoed > m_sentBefore && counters.framesRefused == 0;
    counters.setpointsReplaced = m_setpoints.replaced() - m_replacedBefore;
    counters.writeMedian_ns = m_timings.write.quantile_ns(0.5);
    counters.writeLongest_ns = m_timings.write.longest_ns();
    counters.latencyMedian_ns = m_timings.latency.quantile_ns(0.5);
    counters.latencyLongest_ns = m_timings.latency.longest_ns();
    return counters;
}

PlayerTimings PlaybackCycle::timings() const {
    const std::scoped_lock lock(m_countersMutex);
    return m_timings;
}

void PlaybackCycle::begin(ProgramRequest request) {
    m_program = std::move(request.program);
    m_status.position_s = 0.0;
    m_status.duration_s = m_program.duration_s > 0.0 && m_program.evaluate ? m_program.duration_s : 0.0;
    m_status.loop = request.loop;
    m_status.program = request.number;
    beginAny(PlayerMode::program);
    // Begins at the first deadline, so that the cycles fill the program exactly.
    m_anchorPosition_s = 0.0;
    m_anchor_ns = m_epoch_ns;
    moveTo(request.from_s, m_epoch_ns);
}

void PlaybackCycle::begin(LiveRequest) {
    m_anySetpoint = false;
    m_freshSetpoint = false;
    m_status.position_s = m_status.duration_s = 0.0;
    m_status.loop = false;
    m_status.silent = true;
    beginAny(PlayerMode::live);
}

void PlaybackCycle::beginAny(PlayerMode mode) {
    const std::int64_t now = now_ns();
    m_mode = mode;
    m_status.mode = mode;
    m_status.ending = PlayerEnding::none;
    m_status.message.clear();
    m_status.begun_ns = now;
    m_status.ended_ns = 0;
    m_suspended_ns = m_config.clock->suspended_ns();
    m_epoch_ns = now;
    m_cycle = 0;
    m_extraWritten = false;
    m_connection = m_bracelet.connection();
    {
        const core::BraceletTelemetry telemetry = m_bracelet.telemetry();
        const std::scoped_lock lock(m_countersMutex);
        m_counters = {};
        m_counters.begun_ns = now;
        m_timings = {};
        m_rate.reset();
        m_lostBefore = telemetry.framesLost;
        m_refusedBefore = telemetry.framesRefused;
        m_sentBefore = telemetry.newestSent;
        m_replacedBefore = m_setpoints.replaced();
    }
    if (m_connection == 0)
        end(PlayerEnding::deviceLost);
    else
        publish();
}

void PlaybackCycle::change(ProgramChange change) {
    if (m_mode != PlayerMode::program || change.number != m_status.program || !change.program.evaluate ||
        !(change.program.duration_s > 0.0) || !std::isfinite(change.shift_s))
        return;
    m_program = std::move(change.program);
    m_status.duration_s = m_program.duration_s;
    m_anchorPosition_s += change.shift_s;
    // What lies before the new begin is not played.
    if (const std::int64_t now = now_ns(); programPosition_s(now) < 0.0)
        moveTo(0.0, now);
}

/// NaN, or the end of an endless program, changes nothing.
void PlaybackCycle::moveTo(double position_s, std::int64_t now) {
    position_s = std::clamp(position_s, 0.0, m_status.duration_s);
    if (m_mode != PlayerMode::program || !std::isfinite(position_s))
        return;
    m_anchor_ns = now;
    m_anchorPosition_s = position_s;
}

void PlaybackCycle::end(PlayerEnding ending, std::string message) {
    m_limiter.off(sinceLastFrame_s(now_ns()));
    if (m_config.heat)
        m_config.heat->keep(m_bracelet.description().serial, {m_limiter.heat(), m_lastFrame_ns});
    m_mode = PlayerMode::idle;
    // A bracelet that is gone stops by its own time-out, and is zeroed when it comes back.
    m_bracelet.write({.drive = {}, .timeout_ms = m_config.boardTimeout_ms, .connection = m_connection});
    m_program = {};
    m_status.ended_ns = now_ns();
    m_status.mode = PlayerMode::idle;
    m_status.ending = ending;
    m_status.message = std::move(message);
    m_status.silent = false;
    publish();
}

bool PlaybackCycle::takeSetpoint() {
    std::optional<Setpoint> setpoint = m_setpoints.take();
    if (!setpoint)
        return false;
    m_setpoint = *setpoint;
    // A time in the future would keep it alive too long.
    m_setpoint.made_ns = std::min(m_setpoint.made_ns, now_ns());
    m_anySetpoint = true;
    m_freshSetpoint = true;
    return m_mode == PlayerMode::live;
}

void PlaybackCycle::writeDue(std::int64_t now) {
    const std::int64_t due_ns = deadline_ns(m_cycle);
    const bool regular = now >= due_ns;
    if (regular) {
        const std::scoped_lock lock(m_countersMutex);
        m_timings.lateness.add(now - due_ns);
    }
    // The clock stands still while the machine sleeps; the board does not.
    const std::int64_t slept_ns = m_config.clock->suspended_ns() - m_suspended_ns;
    if (std::max(now - due_ns, slept_ns) > boardTimeout_ns())
        return end(PlayerEnding::stalled);
    const core::BraceletTelemetry telemetry = m_bracelet.telemetry();
    // Reports from before the playing do not count.
    const std::int64_t heard_ns = std::max(telemetry.reported_ns, m_status.begun_ns);
    if (now - heard_ns > m_config.longestSilence_ns)
        return end(PlayerEnding::deviceLost);
    // The bracelet may have reported it while it was idle, before the first frame.
    if (telemetry.board.tooHot)
        return end(PlayerEnding::tooHot);
    core::Intensities wanted{};
    if (!evaluate(now, wanted))
        return;
    const bool raw = m_mode == PlayerMode::program && m_program.raw;
    const core::Drive drive =
        m_limiter.step(wanted, sinceLastFrame_s(now), raw ? DriveRanges{} : m_config.ranges);
    const std::int64_t begun_ns = now_ns();
    // The program may have been slow.
    if (m_stopSwitch.engaged())
        return end(PlayerEnding::stopSwitch);
    if (begun_ns - now > boardTimeout_ns())
        return end(PlayerEnding::stalled);
    const core::WriteResult result = m_bracelet.write(
        {.drive = drive, .timeout_ms = m_config.boardTimeout_ms, .connection = m_connection});
    if (result.outcome != core::WriteOutcome::written)
        return end(PlayerEnding::deviceLost);
    account(drive, begun_ns, result.time_ns);
    if (result.time_ns - begun_ns > boardTimeout_ns())
        return end(PlayerEnding::stalled);
    schedule(regular, std::max(now, result.time_ns));
    publish();
}

/// False when the playing ended instead.
bool PlaybackCycle::evaluate(std::int64_t now, core::Intensities& wanted) {
    if (m_mode == PlayerMode::program)
        return programAt(now, wanted);
    liveAt(now, wanted);
    return true;
}

bool PlaybackCycle::programAt(std::int64_t now, core::Intensities& wanted) {
    const double duration_s = m_status.duration_s;
    double position_s = programPosition_s(now);
    if (position_s >= duration_s) {
        if (!m_status.loop || !(duration_s > 0.0)) {
            countMisses(m_cycle, firstDeadlineAfter(now));
            m_status.position_s = duration_s;
            end(PlayerEnding::finished);
            return false;
        }
        // The turn is the new origin, so that it is played to its end if the loop is turned off.
        position_s = std::fmod(position_s, duration_s);
        m_anchor_ns = now;
        m_anchorPosition_s = position_s;
    }
    m_status.position_s = position_s;
    try {
        wanted = m_program.evaluate(position_s);
    } catch (const std::exception& exception) {
        end(PlayerEnding::sourceFailed, exception.what());
        return false;
    } catch (...) {
        end(PlayerEnding::sourceFailed);
        return false;
    }
    return true;
}

void PlaybackCycle::liveAt(std::int64_t now, core::Intensities& wanted) {
    // An old time must not overflow the difference.
    const bool silent = !m_anySetpoint || m_setpoint.made_ns < now - m_config.setpointLifetime_ns;
    if (silent && !m_status.silent) {
        const std::scoped_lock lock(m_countersMutex);
        ++m_counters.watchdogTrips;
    }
    m_status.silent = silent;
    // NaN is off at once; a zero would be slowed down by the limit of falling.
    if (silent)
        wanted.fill(std::numeric_limits<double>::quiet_NaN());
    else
        wanted = m_setpoint.intensities;
}

void PlaybackCycle::account(const core::Drive& drive, std::int64_t begun_ns, std::int64_t written_ns) {
    m_status.given = m_limiter.output();
    const std::scoped_lock lock(m_countersMutex);
    ++m_counters.framesWritten;
    if (m_counters.firstFrame_ns == 0)
        m_counters.firstFrame_ns = written_ns;
    if (m_counters.onset_ns == 0 && !core::isOff(drive))
        m_counters.onset_ns = written_ns;
    m_timings.write.add(written_ns - begun_ns);
    if (std::exchange(m_freshSetpoint, false) && m_mode == PlayerMode::live && !m_status.silent)
        m_timings.latency.add(written_ns - m_setpoint.made_ns);
    m_rate.add(written_ns);
    m_counters.rate_Hz = m_rate.rate_Hz(written_ns);
}

void PlaybackCycle::schedule(bool regular, std::int64_t now) {
    m_extraWritten = !regular;
    if (!regular)
        return;
    // Frames are never written in a row to catch up.
    const std::int64_t next = std::max(m_cycle + 1, firstDeadlineAfter(now));
    countMisses(m_cycle + 1, next);
    m_cycle = next;
}

/// Cycles from `first` until before `next`, as far as they lie in the program.
void PlaybackCycle::countMisses(std::int64_t first, std::int64_t next) {
    if (m_mode == PlayerMode::program && !m_status.loop)
        while (next > first && programPosition_s(deadline_ns(next - 1)) >= m_status.duration_s)
            --next;
    if (next > first) {
        const std::scoped_lock lock(m_countersMutex);
        m_counters.deadlineMisses += static_cast<std::uint64_t>(next - first);
    }
}

std::int64_t PlaybackCycle::firstDeadlineAfter(std::int64_t now) const {
    const double periods = std::floor(static_cast<double>(now - m_epoch_ns) * m_rate_Hz / kNsPerS);
    auto cycle = static_cast<std::int64_t>(periods);
    while (deadline_ns(cycle) <= now)
        ++cycle;
    return cycle;
}

double PlaybackCycle::programPosition_s(std::int64_t time_ns) const {
    return m_anchorPosition_s + static_cast<double>(time_ns - m_anchor_ns) / kNsPerS;
}

double PlaybackCycle::sinceLastFrame_s(std::int64_t now) {
    return static_cast<double>(now - std::exchange(m_lastFrame_ns, now)) / kNsPerS;
}

std::int64_t PlaybackCycle::deadline_ns(std::int64_t cycle) const {
    return m_epoch_ns +
           static_cast<std::int64_t>(std::llround(static_cast<double>(cycle) * kNsPerS / m_rate_Hz));
}

void PlaybackCycle::publish() {
    m_status.given = m_limiter.output();
    m_published.set(m_status);
}

} // namespace teleta::playback
