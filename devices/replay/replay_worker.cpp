// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/replay_worker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::replay {

namespace {

constexpr std::size_t kFramesPerBlock = 64;
constexpr double kSeamOfUnknownRate_s = 0.1;
/// A worker that is later than this does not catch up.
constexpr std::int64_t kLongestCatchUp_ns = 500'000'000;

} // namespace

ReplayWorker::ReplayWorker(ReplayCursor cursor, double nominalRate_Hz, ReplayConfig config)
    : m_config(std::move(config))
    , m_nominalRate_Hz(nominalRate_Hz)
    , m_outlet(m_config.queueBlocks)
    , m_desk(m_config.clock, m_config.autoplay, m_config.loop, m_config.speed)
    , m_cursor(std::move(cursor)) {
    m_index.add(m_cursor.first());
}

void ReplayWorker::open(core::Wakeup& consumer) {
    m_outlet.open(consumer, now_ns());
    m_delivered.reset();
    m_desk.set([this](PlaybackCommands& commands) {
        commands.playing = m_config.autoplay;
        if (!commands.playing)
            commands.seek_s = 0.0;
    });
}

void ReplayWorker::run(const std::stop_token& stop) {
    const bool again = m_discontinuity;
    rewind();
    m_discontinuity = again;
    while (!stop.stop_requested()) {
        const PlaybackCommands previous = std::exchange(
            m_active, m_desk.take([this] { m_abandonScan.store(false, std::memory_order_relaxed); }));
        if (m_active.seek_s)
            seekTo(*m_active.seek_s, stop);
        if (m_active.steps != 0)
            stepBy(m_active.steps, stop);
        const core::DeviceState state = m_outlet.state();
        const bool ended = state == core::DeviceState::finished || state == core::DeviceState::lost;
        if (!m_active.playing) {
            if (!ended)
                m_outlet.setState(core::DeviceState::paused, now_ns());
            m_desk.waitUntil(core::PacingClock::kNever_ns, stop);
            continue;
        }
        if (ended)
            rewind();
        else if (m_delivered && (!previous.playing || previous.speed != m_active.speed))
            anchorAt(timeOf_s(*m_delivered));
        playDue(stop);
    }
    m_outlet.setState(core::DeviceState::closed, now_ns());
    m_discontinuity = true;
}

void ReplayWorker::buildIndex(const std::stop_token& stop) {
    core::Expected<ReplayCursor> cursor = ReplayCursor::open(m_config.path, m_config.layout);
    if (cursor && cursor->goTo(m_index.atFrame(m_index.extent().frames))) {
        for (;;) {
            if (stop.stop_requested())
                return;
            // What cannot be read ends the recording; the worker reports it when it comes there.
            const core::Expected<bool> any = cursor->read();
            if (!any || !*any)
                break;
            if (cursor->place().frame >= m_index.extent().frames)
                m_index.add(cursor->place());
        }
    }
    m_index.complete();
}

void ReplayWorker::wake() {
    m_desk.wake();
}

void ReplayWorker::play() {
    m_desk.setPlaying(true);
}

void ReplayWorker::pause() {
    m_desk.setPlaying(false);
}

void ReplayWorker::step(int frames) {
    m_desk.command([frames](PlaybackCommands& commands) {
        commands.playing = false;
        commands.steps += frames;
    });
}

void ReplayWorker::setSpeed(double factor) {
    m_desk.setSpeed(factor);
}

void ReplayWorker::seek(double time_s) {
    if (std::isnan(time_s))
        return;
    m_desk.command([this, time_s](PlaybackCommands& commands) {
        commands.seek_s = std::max(time_s, 0.0);
        commands.steps = 0;
        m_abandonScan.store(true, std::memory_order_relaxed);
    });
}

void ReplayWorker::setLoop(bool loop) {
    m_desk.setLoop(loop);
}

core::PlaybackPosition ReplayWorker::position() const {
    core::PlaybackPosition position;
    const std::optional<double> sought_s = m_desk.describe(position);
    const Shown shown = m_shown.get();
    const FrameIndex::Extent extent = m_index.extent();
    position.time_s = shown.time_s;
    position.frame = shown.frame;
    position.frames = std::max(extent.frames, shown.frame + 1);
    position.duration_s = m_config.rate_Hz ? static_cast<double>(position.frames - 1) / *m_config.rate_Hz
                                           : std::max(extent.lastTime_s - extent.firstTime_s, shown.time_s);
    position.indexed = extent.complete;
    position.target_s = std::min(sought_s.value_or(position.time_s), position.duration_s);
    return position;
}

void ReplayWorker::seekTo(double time_s, const std::stop_token& stop) {
    FramePlace from;
    if (m_config.rate_Hz) {
        const double frame = std::min(std::floor(time_s * *m_config.rate_Hz), 0x1p62);
        from = m_index.atFrame(frame > 1.0 ? static_cast<std::uint64_t>(frame) - 1 : 0);
    } else {
        from = m_index.beforeTime(m_cursor.first().time_s + time_s);
    }
    if (scan(
            from, [&](const FramePlace& place) { return timeOf_s(place) >= time_s; }, stop))
        showPending(stop);
}

void ReplayWorker::stepBy(long long frames, const std::stop_token& stop) {
    const long long shown = m_delivered ? static_cast<long long>(m_delivered->frame) : -1;
    const long long target = std::max(shown + frames, 0LL);
    if (target == shown)
        return;
    const auto frame = static_cast<std::uint64_t>(target);
    const bool isNext = m_pending && m_cursor.place().frame == frame;
    if (isNext ||
        scan(
            m_index.atFrame(frame), [frame](const FramePlace& place) { return place.frame >= frame; }, stop))
        showPending(stop);
}

/// Reads on until a frame is reached, or the last one, which is then pending. False when that was not to be.
template <typename Reached>
bool ReplayWorker::scan(const FramePlace& from, const Reached& reached, const std::stop_token& stop) {
    const FramePlace& last = m_cursor.place();
    const bool onTheWay = m_cursor.next() == last.frame + 1 && last.frame >= from.frame && !reached(last);
    m_pending = false;
    if (!onTheWay) {
        if (const core::Expected<void> done = m_cursor.goTo(from); !done) {
            endAs(core::DeviceState::lost, describe(done.error()));
            return false;
        }
    }
    for (;;) {
        if (m_abandonScan.load(std::memory_order_relaxed) || stop.stop_requested())
            return false;
        const core::Expected<bool> any = m_cursor.read();
        if (!any) {
            endAs(core::DeviceState::lost, describe(any.error()));
            return false;
        }
        if (!*any || reached(m_cursor.place())) {
            m_pending = true;
            return true;
        }
    }
}

/// Delivers the pending frame now, whatever its time.
void ReplayWorker::showPending(const std::stop_token& stop) {
    const FramePlace& place = m_cursor.place();
    anchorAt(timeOf_s(place));
    if (m_delivered && m_delivered->frame == place.frame) {
        m_pending = false;
        return;
    }
    if (m_delivered && m_delivered->frame + 1 != place.frame)
        m_discontinuity = true;
    core::SampleBlock block;
    append(block);
    deliver(block, stop);
}

void ReplayWorker::playDue(const std::stop_token& stop) {
    if (!m_pending) {
        const core::Expected<bool> any = m_cursor.read();
        m_pending = any && *any;
        if (!m_pending) {
            reachEnd(any);
            return;
        }
    }
    const bool unpaced = std::isinf(m_active.speed);
    const std::int64_t start_ns = now_ns();
    if (!unpaced) {
        const std::int64_t next_ns = due_ns(timeOf_s(m_cursor.place()));
        if (start_ns < next_ns) {
            if (m_delivered)
                m_outlet.setState(core::DeviceState::live, start_ns);
            m_desk.waitUntil(next_ns, stop);
            return;
        }
        if (start_ns - next_ns > kLongestCatchUp_ns)
            anchorAt(timeOf_s(m_cursor.place()));
    }
    core::SampleBlock block;
    do {
        append(block);
        const core::Expected<bool> any = m_cursor.read();
        m_pending = any && *any;
        if (!m_pending) {
            deliver(block, stop);
            reachEnd(any);
            return;
        }
    } while (block.frames() < kFramesPerBlock && (unpaced || due_ns(timeOf_s(m_cursor.place())) <= start_ns));
    deliver(block, stop);
}

/// Goes to the first frame, which is due now.
void ReplayWorker::rewind() {
    m_pending = false;
    m_discontinuity = true;
    anchorAt(timeOf_s(m_cursor.first()));
    if (const core::Expected<void> done = m_cursor.goTo(m_cursor.first()); !done)
        endAs(core::DeviceState::lost, describe(done.error()));
}

/// Behind the last frame, or before a row that cannot be read.
void ReplayWorker::reachEnd(const core::Expected<bool>& read) {
    if (!read) {
        endAs(core::DeviceState::lost, describe(read.error()));
    } else if (!m_active.loop) {
        endAs(core::DeviceState::finished);
    } else {
        const double period_s = m_nominalRate_Hz > 0.0 ? 1.0 / m_nominalRate_Hz : kSeamOfUnknownRate_s;
        const std::int64_t seam_ns = due_ns(timeOf_s(m_cursor.place()) + period_s);
        rewind();
        m_anchor_ns = seam_ns;
    }
}

void ReplayWorker::endAs(core::DeviceState state, std::string message) {
    m_active.playing = false;
    m_desk.set([](PlaybackCommands& commands) { commands.playing = false; });
    m_outlet.setState(state, now_ns(), std::move(message));
}

void ReplayWorker::append(core::SampleBlock& block) {
    const FramePlace& place = m_cursor.place();
    block.time_ns.push_back(now_ns());
    block.sourceTime_s.push_back(m_config.rate_Hz ? timeOf_s(place) : place.time_s);
    block.values.insert(block.values.end(), m_cursor.values().begin(), m_cursor.values().end());
    m_delivered = place;
    m_pending = false;
}

void ReplayWorker::deliver(core::SampleBlock& block, const std::stop_token& stop) {
    block.channels = m_cursor.values().size();
    block.discontinuity = std::exchange(m_discontinuity, false);
    m_shown.set({.time_s = timeOf_s(*m_delivered), .frame = m_delivered->frame});
    const core::DeviceState state = m_active.playing ? core::DeviceState::live : core::DeviceState::paused;
    if (!std::isinf(m_active.speed)) {
        m_outlet.deliver(std::move(block), state);
        return;
    }
    while (!m_outlet.tryDeliver(block, state)) {
        if (!m_desk.waitForRoom(stop))
            return;
    }
}

void ReplayWorker::anchorAt(double time_s) {
    m_anchor_ns = now_ns();
    m_anchorTime_s = time_s;
}

/// From the first frame, in s.
double ReplayWorker::timeOf_s(const FramePlace& place) const {
    return m_config.rate_Hz ? static_cast<double>(place.frame) / *m_config.rate_Hz
                            : place.time_s - m_cursor.first().time_s;
}

std::int64_t ReplayWorker::due_ns(double time_s) const {
    // Bounded: a gap in a recording may be longer than the clock can count.
    constexpr double kLongest_ns = 4e18;
    const double wait_ns = (time_s - m_anchorTime_s) / m_active.speed * 1e9;
    return m_anchor_ns + static_cast<std::int64_t>(std::fmax(std::fmin(wait_ns, kLongest_ns), -kLongest_ns));
}

} // namespace teleta::replay
