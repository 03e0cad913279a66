// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_worker.h"

#include "backend/recording/stream_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::replay {

namespace {

/// The first frame after a time that was asked for is shown for it when it comes within this time.
constexpr double kShortGap_ns = 50e6;
/// A worker that is later than this does not catch up.
constexpr std::int64_t kLongestLag_ns = 500'000'000;

core::JointSample jointSample(std::span<const double> values) {
    core::JointSample sample;
    auto value = values.begin();
    for (core::JointArray* joints : {&sample.angle_rad, &sample.torque_Nm, &sample.reference_rad}) {
        std::copy_n(value, core::kArmJoints, joints->begin());
        value += core::kArmJoints;
    }
    return sample;
}

std::unique_ptr<RecordedOutlet> makeOutlet(const RecordedConfig& config) {
    if (config.camera)
        return std::make_unique<RecordedCameraOutlet>(config.queuePictures);
    return std::make_unique<RecordedArrayOutlet>(config.queueBlocks);
}

} // namespace

RecordedWorker::RecordedWorker(RecordedConfig config, RecordedFacts facts)
    : m_config(std::move(config))
    , m_facts(std::move(facts))
    , m_span(m_config.span.value_or(RecordedConfig::Span{m_facts.extent.first_ns, m_facts.extent.last_ns}))
    , m_outlet(makeOutlet(m_config))
    , m_joints(m_config.queueJoints)
    , m_desk(m_config.clock, m_config.autoplay, m_config.loop, m_config.speed) {
    m_shown_ns.set(m_span.first_ns);
}

void RecordedWorker::open(core::Wakeup& consumer) {
    m_consumer = &consumer;
    m_outlet->open(consumer, now_ns());
    m_jointsRead.store(0);
    m_jointOverflowAtOpen = m_joints.overflow();
    m_desk.set([this](PlaybackCommands& commands) {
        commands.playing = m_config.autoplay;
        commands.seek_s = 0.0;
    });
}

void RecordedWorker::wake() {
    m_desk.wake();
}

void RecordedWorker::play() {
    m_desk.setPlaying(true);
}

void RecordedWorker::pause() {
    m_desk.setPlaying(false);
}

void RecordedWorker::step(int frames) {
    m_desk.command([frames](PlaybackCommands& commands) {
        commands.playing = false;
        commands.steps += frames;
    });
}

void RecordedWorker::setSpeed(double factor) {
    m_desk.setSpeed(factor);
}

void RecordedWorker::seek(double time_s) {
    if (std::isnan(time_s))
        return;
    m_desk.command([time_s](PlaybackCommands& commands) {
        commands.seek_s = std::max(time_s, 0.0);
        commands.steps = 0;
    });
}

void RecordedWorker::setLoop(bool loop) {
    m_desk.setLoop(loop);
}

double RecordedWorker::period_ns() const {
    const recording::Recording::Extent& extent = m_facts.extent;
    return extent.frames > 1 ? static_cast<double>(extent.last_ns - extent.first_ns) /
                                   static_cast<double>(extent.frames - 1)
                             : 0.0;
}

core::PlaybackPosition RecordedWorker::position() const {
    core::PlaybackPosition position;
    const std::optional<double> sought_s = m_desk.describe(position);
    const std::int64_t shown_ns = m_shown_ns.get();
    const double since_ns = static_cast<double>(shown_ns - m_facts.extent.first_ns);
    position.time_s = static_cast<double>(shown_ns - m_span.first_ns) * 1e-9;
    position.duration_s = static_cast<double>(m_span.last_ns - m_span.first_ns) * 1e-9;
    position.frames = m_facts.extent.frames;
    if (period_ns() > 0.0 && since_ns > 0.0)
        position.frame =
            std::min(static_cast<std::uint64_t>(std::llround(since_ns / period_ns())), position.frames - 1);
    position.indexed = true;
    position.damagedBlocks = damagedBlocks();
    position.target_s = std::min(sought_s.value_or(position.time_s), position.duration_s);
    return position;
}

std::vector<core::PlaybackMark> RecordedWorker::marks() const {
    std::vector<core::PlaybackMark> marks;
    for (const RecordedFacts::Mark& mark : m_facts.marks)
        marks.push_back({static_cast<double>(mark.time_ns - m_span.first_ns) * 1e-9,
                         static_cast<double>(mark.time_ns - m_facts.start_ns) * 1e-9, mark.text});
    return marks;
}

core::DeviceStatus RecordedWorker::jointStatus() const {
    core::DeviceStatus status = m_outlet->status();
    status.framesRead = m_jointsRead.load();
    status.framesLost = m_joints.overflow() - m_jointOverflowAtOpen;
    const bool runs = status.state == core::DeviceState::live;
    const double speed = position().speed;
    status.rate_Hz = runs && std::isfinite(speed) ? m_config.arm.nominalRate_Hz * speed : 0.0;
    return status;
}

void RecordedWorker::run(const std::stop_token& stop) {
    // A database belongs to the thread that opened it.
    const core::Expected<recording::Recording> recording = recording::Recording::open(m_config.path);
    if (recording) {
        RecordedTrack frames(*recording, m_config.stream);
        std::optional<RecordedTrack> joints;
        if (m_config.jointStream)
            joints.emplace(*recording, *m_config.jointStream);
        m_references = std::make_unique<RecordedReferences>(*recording, m_config.referenceStream);
        play(frames, joints ? &*joints : nullptr, stop);
        m_references.reset();
    } else {
        loseBy(recording.error());
        while (!stop.stop_requested()) {
            (void)m_desk.take([] {});
            m_desk.waitUntil(core::PacingClock::kNever_ns, stop);
        }
    }
    m_outlet->setState(core::DeviceState::closed, now_ns());
}

void RecordedWorker::play(RecordedTrack& frames, RecordedTrack* joints, const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const PlaybackCommands previous = std::exchange(m_active, m_desk.take([] {}));
        const core::DeviceState state = m_outlet->state();
        const bool ended = state == core::DeviceState::finished || state == core::DeviceState::lost;
        core::Expected<void> done;
        if (m_active.seek_s)
            done = seekTo(frames, joints, *m_active.seek_s, commanded_ns(), stop);
        else if (ended && m_active.playing)
            done = seekTo(frames, joints, 0.0, commanded_ns(), stop);
        else if (previous.playing != m_active.playing || previous.speed != m_active.speed) {
            const std::int64_t at_ns = previous.playing ? now_ns() : commanded_ns();
            const std::int64_t reached = reached_ns(previous, at_ns);
            anchorAt(reached, at_ns);
            // What is played together stands at one time, whenever the last frame of each was.
            if (m_config.span)
                m_shown_ns.set(std::min(reached, m_span.last_ns));
            // As fast as possible, frames run ahead of the clock.
            if (std::isinf(previous.speed))
                m_jumped = m_jointsJumped = true;
        }
        if (done && m_active.steps != 0)
            done = stepBy(frames, joints, m_active.steps, stop);
        countDamage(frames, joints);
        if (done && !m_active.playing) {
            if (!ended || m_active.seek_s)
                m_outlet->setState(core::DeviceState::paused, now_ns());
            m_desk.waitUntil(core::PacingClock::kNever_ns, stop);
            continue;
        }
        if (done)
            done = playDue(frames, joints, stop);
        if (!done) {
            // What came before it is not lost.
            if (m_outlet->taken() > 0)
                deliver(stop);
            loseBy(done.error());
        }
        countDamage(frames, joints);
    }
}

void RecordedWorker::countDamage(const RecordedTrack& frames, const RecordedTrack* joints) {
    m_damagedBlocks.store(frames.damagedBlocks() + (joints != nullptr ? joints->damagedBlocks() : 0));
}

core::Expected<void> RecordedWorker::seekTo(RecordedTrack& frames, RecordedTrack* joints, double time_s,
                                            std::int64_t at_ns, const std::stop_token& stop) {
    const double duration_s = static_cast<double>(m_span.last_ns - m_span.first_ns) * 1e-9;
    const std::int64_t wanted_ns =
        time_s < duration_s ? m_span.first_ns + std::llround(time_s * 1e9) : m_span.last_ns;
    // Of what is played beside it the end may be later: the last frame is then shown.
    const std::int64_t time_ns = std::min(wanted_ns, m_facts.extent.last_ns);
    if (const core::Expected<void> done = frames.seek(time_ns); !done)
        return done;
    if (frames.atEnd()) {
        // The last block may be damaged.
        if (const auto moved = frames.back(1); !moved)
            return core::Unexpected(moved.error());
    }
    if (frames.atEnd()) { // nothing of it can be read
        m_jointsJumped = true;
        anchorAt(wanted_ns, at_ns);
        m_shown_ns.set(wanted_ns);
        return joints != nullptr ? joints->seek(wanted_ns) : core::Expected<void>();
    }
    m_jumped = true;
    if (!m_config.span)
        return show(frames, joints, frames.time_ns(), at_ns, stop);
    // What is played beside it has frames at other times: all go on from the time that was asked for.
    const double gap_ns = std::max(2.0 * period_ns(), kShortGap_ns);
    const std::int64_t ahead_ns = frames.time_ns() - wanted_ns;
    if (ahead_ns > 0 && (m_active.playing || static_cast<double>(ahead_ns) > gap_ns)) {
        m_jointsJumped = true;
        anchorAt(wanted_ns, at_ns);
        m_shown_ns.set(wanted_ns);
        return joints != nullptr ? joints->seek(wanted_ns) : core::Expected<void>();
    }
    const core::Expected<void> shown =
        show(frames, joints, std::max(frames.time_ns(), wanted_ns), at_ns, stop);
    m_shown_ns.set(wanted_ns);
    return shown;
}

core::Expected<void> RecordedWorker::stepBy(RecordedTrack& frames, RecordedTrack* joints, long long by,
                                            const std::stop_token& stop) {
    // The track is at the frame behind the one that is shown.
    if (by < 0) {
        const core::Expected<std::uint64_t> moved = frames.back(static_cast<std::uint64_t>(-by) + 1);
        if (!moved)
            return core::Unexpected(moved.error());
        if (*moved < 2) // the first one is shown already
            return *moved == 0 ? core::Expected<void>() : frames.advance();
    } else {
        if (frames.atEnd())
            return {};
        for (long long i = 1; i < by && !frames.atEnd() && !stop.stop_requested(); ++i) {
            if (const core::Expected<void> done = frames.advance(); !done)
                return done;
        }
        if (frames.atEnd()) {
            if (const auto moved = frames.back(1); !moved)
                return core::Unexpected(moved.error());
        }
    }
    m_jumped = m_jumped || by != 1;
    return show(frames, joints, frames.time_ns(), now_ns(), stop);
}

/// Delivers the frame that the track is at now, for this time, also when paused.
core::Expected<void> RecordedWorker::show(RecordedTrack& frames, RecordedTrack* joints, std::int64_t time_ns,
                                          std::int64_t at_ns, const std::stop_token& stop) {
    if (joints != nullptr) {
        if (const core::Expected<void> done = joints->seek(time_ns); !done)
            return done;
        m_jointsJumped = true;
    }
    anchorAt(time_ns, at_ns);
    take(frames);
    m_shown_ns.set(time_ns);
    deliver(stop);
    return frames.advance();
}

core::Expected<void> RecordedWorker::playEnd(RecordedTrack& frames, RecordedTrack* joints,
                                             const std::stop_token& stop) {
    const bool unpaced = std::isinf(m_active.speed);
    // What is played together ends together, whatever the period of each.
    const bool hasSeam = m_active.loop && !m_config.span;
    const std::int64_t end_ns = due_ns(hasSeam ? m_span.last_ns + std::llround(period_ns()) : m_span.last_ns);
    if (!unpaced && now_ns() < end_ns) {
        m_outlet->setState(core::DeviceState::live, now_ns());
        m_desk.waitUntil(end_ns, stop);
        return {};
    }
    // An instant would begin anew without end.
    if (m_active.loop && m_span.last_ns > m_span.first_ns) {
        // The next pass begins when this one ended, not when that was noticed: what is played together
        // notices it at different times.
        const std::int64_t now = now_ns();
        const bool isLate = unpaced || now - end_ns > kLongestLag_ns;
        return seekTo(frames, joints, 0.0, isLate ? now : end_ns, stop);
    }
    m_shown_ns.set(m_span.last_ns);
    endAs(core::DeviceState::finished);
    return {};
}

core::Expected<void> RecordedWorker::playDue(RecordedTrack& frames, RecordedTrack* joints,
                                             const std::stop_token& stop) {
    const bool unpaced = std::isinf(m_active.speed);
    const auto hasJoints = [&] { return joints != nullptr && !joints->atEnd(); };
    const auto jointsNext = [&] {
        return hasJoints() && (frames.atEnd() || joints->time_ns() <= frames.time_ns());
    };
    if (frames.atEnd() && !hasJoints())
        return playEnd(frames, joints, stop);
    const std::int64_t first_ns = jointsNext() ? joints->time_ns() : frames.time_ns();
    const std::int64_t now = now_ns();
    if (!unpaced) {
        const std::int64_t next_ns = due_ns(first_ns);
        if (now < next_ns) {
            m_outlet->setState(core::DeviceState::live, now);
            m_desk.waitUntil(next_ns, stop);
            return {};
        }
        if (now - next_ns > kLongestLag_ns)
            anchorAt(first_ns, now);
    }
    const auto isDue = [&](const RecordedTrack& track) { return unpaced || due_ns(track.time_ns()) <= now; };
    // Joints first, up to the newest frame of the block: a skin frame that was read before them is then
    // there.
    while (!m_outlet->isFull()) {
        if (jointsNext() && isDue(*joints)) {
            deliver(*joints, stop);
            if (const core::Expected<void> done = joints->advance(); !done)
                return done;
        } else if (!frames.atEnd() && !jointsNext() && isDue(frames)) {
            // A jump can only be told at the beginning of a block.
            if (m_outlet->taken() > 0 && frames.jumps())
                break;
            take(frames);
            if (const core::Expected<void> done = frames.advance(); !done)
                return done;
        } else {
            break;
        }
        if (stop.stop_requested())
            return {};
    }
    if (m_outlet->taken() > 0)
        deliver(stop);
    else if (joints != nullptr && m_consumer != nullptr)
        m_consumer->notify();
    return {};
}

void RecordedWorker::take(const RecordedTrack& frames) {
    const bool jumped = std::exchange(m_jumped, false) || frames.jumps();
    m_outlet->take(frames, {.time_ns = std::max(due_ns(frames.time_ns()), m_anchor_ns),
                            .sourceTime_s = static_cast<double>(frames.time_ns() - m_facts.start_ns) / 1e9,
                            .jumped = jumped,
                            .reference = m_references->changeAt(frames.time_ns())});
    m_shown_ns.set(frames.time_ns());
}

void RecordedWorker::deliver(const std::stop_token& stop) {
    const core::DeviceState state = m_active.playing ? core::DeviceState::live : core::DeviceState::paused;
    while (!m_outlet->deliver(state, std::isinf(m_active.speed))) {
        if (!m_desk.waitForRoom(stop))
            return;
    }
}

void RecordedWorker::deliver(const RecordedTrack& joints, const std::stop_token& stop) {
    core::JointSample sample = jointSample(joints.values<double>());
    sample.time_ns = due_ns(joints.time_ns());
    sample.sourceTime_s = static_cast<double>(joints.time_ns() - m_facts.start_ns) / 1e9;
    sample.discontinuity = std::exchange(m_jointsJumped, false) || joints.jumps();
    m_jointsRead.fetch_add(1, std::memory_order_relaxed);
    if (!std::isinf(m_active.speed)) {
        m_joints.push(std::move(sample));
        return;
    }
    while (!m_joints.tryPush(sample)) {
        m_consumer->notify();
        if (!m_desk.waitForRoom(stop))
            return;
    }
}

void RecordedWorker::endAs(core::DeviceState state, std::string message) {
    m_active.playing = false;
    m_desk.set([](PlaybackCommands& commands) { commands.playing = false; });
    m_outlet->setState(state, now_ns(), std::move(message));
}

void RecordedWorker::loseBy(core::Error error) {
    std::string message = describe(error);
    m_error.set(std::move(error));
    endAs(core::DeviceState::lost, std::move(message));
}

void RecordedWorker::anchorAt(std::int64_t time_ns, std::int64_t at_ns) {
    m_anchor_ns = at_ns;
    m_anchorTime_ns = time_ns;
}

std::int64_t RecordedWorker::due_ns(std::int64_t time_ns) const {
    // Bounded: a gap in a recording may be longer than the clock can count.
    constexpr double kLongest_ns = 4e18;
    const double speed = std::isinf(m_active.speed) ? 1.0 : m_active.speed;
    const double wait_ns = static_cast<double>(time_ns - m_anchorTime_ns) / speed;
    return m_anchor_ns + static_cast<std::int64_t>(std::clamp(wait_ns, -kLongest_ns, kLongest_ns));
}

std::int64_t RecordedWorker::commanded_ns() const {
    const std::int64_t now = now_ns();
    return now - m_active.at_ns > kLongestLag_ns ? now : m_active.at_ns;
}

std::int64_t RecordedWorker::reached_ns(const PlaybackCommands& previous, std::int64_t now_ns) const {
    const std::int64_t shown_ns = m_shown_ns.get();
    if (!previous.playing || std::isinf(previous.speed))
        return shown_ns;
    // The frames of what is played beside it were shown at other times: those do not count.
    const double played_ns = static_cast<double>(now_ns - m_anchor_ns) * previous.speed;
    return std::max<std::int64_t>(shown_ns, m_anchorTime_ns + std::llround(played_ns));
}

} // namespace teleta::replay
