// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_worker.h"

#include "backend/recording/stream_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::replay {

namespace {

constexpr std::size_t kRecordedFramesPerBlock = 64;
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

} // namespace

RecordedWorker::RecordedWorker(RecordedConfig config, const recording::Recording::Extent& extent,
                               std::int64_t start_ns)
    : m_config(std::move(config))
    , m_extent(extent)
    , m_start_ns(start_ns)
    , m_outlet(m_config.queueBlocks)
    , m_joints(m_config.queueJoints)
    , m_desk(m_config.clock, m_config.autoplay, m_config.loop, m_config.speed) {
    m_shown_ns.set(extent.first_ns);
}

void RecordedWorker::open(core::Wakeup& consumer) {
    m_consumer = &consumer;
    m_outlet.open(consumer, now_ns());
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
    return m_extent.frames > 1 ? static_cast<double>(m_extent.last_ns - m_extent.first_ns) /
                                     static_cast<double>(m_extent.frames - 1)
                               : 0.0;
}

core::PlaybackPosition RecordedWorker::position() const {
    const std::int64_t shown_ns = m_shown_ns.get() - m_extent.first_ns;
    core::PlaybackPosition position;
    position.time_s = static_cast<double>(shown_ns) * 1e-9;
    position.duration_s = static_cast<double>(m_extent.last_ns - m_extent.first_ns) * 1e-9;
    position.frames = m_extent.frames;
    position.frame =
        period_ns() > 0.0
            ? std::min(static_cast<std::uint64_t>(std::llround(static_cast<double>(shown_ns) / period_ns())),
                       m_extent.frames - 1)
            : 0;
    position.indexed = true;
    m_desk.describe(position);
    return position;
}

core::DeviceStatus RecordedWorker::jointStatus() const {
    core::DeviceStatus status = m_outlet.status();
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
        RecordedTrack array(*recording, m_config.arrayStream);
        std::optional<RecordedTrack> joints;
        if (m_config.jointStream)
            joints.emplace(*recording, *m_config.jointStream);
        play(array, joints ? &*joints : nullptr, stop);
    } else {
        loseBy(recording.error());
        while (!stop.stop_requested()) {
            (void)m_desk.take([] {});
            m_desk.waitUntil(core::PacingClock::kNever_ns, stop);
        }
    }
    m_outlet.setState(core::DeviceState::closed, now_ns());
}

void RecordedWorker::play(RecordedTrack& array, RecordedTrack* joints, const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const PlaybackCommands previous = std::exchange(m_active, m_desk.take([] {}));
        const core::DeviceState state = m_outlet.state();
        const bool ended = state == core::DeviceState::finished || state == core::DeviceState::lost;
        core::Expected<void> done;
        if (m_active.seek_s)
            done = seekTo(array, joints, *m_active.seek_s, stop);
        else if (ended && m_active.playing)
            done = seekTo(array, joints, 0.0, stop);
        else if (previous.playing != m_active.playing || previous.speed != m_active.speed) {
            anchorAt(m_shown_ns.get());
            // As fast as possible, frames run ahead of the clock.
            if (std::isinf(previous.speed))
                m_jumped = m_jointsJumped = true;
        }
        if (done && m_active.steps != 0)
            done = stepBy(array, joints, m_active.steps, stop);
        countDamage(array, joints);
        if (done && !m_active.playing) {
            if (!ended || m_active.seek_s)
                m_outlet.setState(core::DeviceState::paused, now_ns());
            m_desk.waitUntil(core::PacingClock::kNever_ns, stop);
            continue;
        }
        if (done)
            done = playDue(array, joints, stop);
        if (!done)
            loseBy(done.error());
        countDamage(array, joints);
    }
}

void RecordedWorker::countDamage(const RecordedTrack& array, const RecordedTrack* joints) {
    m_damagedBlocks.store(array.damagedBlocks() + (joints != nullptr ? joints->damagedBlocks() : 0));
}

core::Expected<void> RecordedWorker::seekTo(RecordedTrack& array, RecordedTrack* joints, double time_s,
                                            const std::stop_token& stop) {
    const double duration_s = static_cast<double>(m_extent.last_ns - m_extent.first_ns) * 1e-9;
    const std::int64_t time_ns =
        time_s < duration_s ? m_extent.first_ns + std::llround(time_s * 1e9) : m_extent.last_ns;
    if (const core::Expected<void> done = array.seek(time_ns); !done)
        return done;
    if (array.atEnd()) {
        // The last block may be damaged.
        if (const auto moved = array.back(1); !moved)
            return core::Unexpected(moved.error());
    }
    if (array.atEnd())
        return {};
    m_jumped = true;
    return show(array, joints, stop);
}

core::Expected<void> RecordedWorker::stepBy(RecordedTrack& array, RecordedTrack* joints, long long frames,
                                            const std::stop_token& stop) {
    // The track is at the frame behind the one that is shown.
    if (frames < 0) {
        const core::Expected<std::uint64_t> moved = array.back(static_cast<std::uint64_t>(-frames) + 1);
        if (!moved)
            return core::Unexpected(moved.error());
        if (*moved < 2) // the first one is shown already
            return *moved == 0 ? core::Expected<void>() : array.advance();
    } else {
        if (array.atEnd())
            return {};
        for (long long i = 1; i < frames && !array.atEnd() && !stop.stop_requested(); ++i) {
            if (const core::Expected<void> done = array.advance(); !done)
                return done;
        }
        if (array.atEnd()) {
            if (const auto moved = array.back(1); !moved)
                return core::Unexpected(moved.error());
        }
    }
    m_jumped = m_jumped || frames != 1;
    return show(array, joints, stop);
}

/// Delivers the array's frame now, whatever its time, also when paused.
core::Expected<void> RecordedWorker::show(RecordedTrack& array, RecordedTrack* joints,
                                          const std::stop_token& stop) {
    if (joints != nullptr) {
        if (const core::Expected<void> done = joints->seek(array.time_ns()); !done)
            return done;
        m_jointsJumped = true;
    }
    anchorAt(array.time_ns());
    core::SampleBlock block;
    append(block, array);
    deliver(block, stop);
    return array.advance();
}

core::Expected<void> RecordedWorker::playDue(RecordedTrack& array, RecordedTrack* joints,
                                             const std::stop_token& stop) {
    const bool unpaced = std::isinf(m_active.speed);
    const auto hasJoints = [&] { return joints != nullptr && !joints->atEnd(); };
    const auto jointsNext = [&] {
        return hasJoints() && (array.atEnd() || joints->time_ns() <= array.time_ns());
    };
    if (array.atEnd() && !hasJoints()) {
        if (!m_active.loop) {
            endAs(core::DeviceState::finished);
            return {};
        }
        const std::int64_t seam_ns = due_ns(m_extent.last_ns + std::llround(period_ns()));
        if (!unpaced && now_ns() < seam_ns) {
            m_outlet.setState(core::DeviceState::live, now_ns());
            m_desk.waitUntil(seam_ns, stop);
            return {};
        }
        return seekTo(array, joints, 0.0, stop);
    }
    const std::int64_t first_ns = jointsNext() ? joints->time_ns() : array.time_ns();
    const std::int64_t now = now_ns();
    if (!unpaced) {
        const std::int64_t next_ns = due_ns(first_ns);
        if (now < next_ns) {
            m_outlet.setState(core::DeviceState::live, now);
            m_desk.waitUntil(next_ns, stop);
            return {};
        }
        if (now - next_ns > kLongestLag_ns)
            anchorAt(first_ns);
    }
    core::SampleBlock block;
    const auto isDue = [&](const RecordedTrack& track) { return unpaced || due_ns(track.time_ns()) <= now; };
    // Joints first, up to the newest frame of the block: a skin frame that was read before them is then
    // there.
    while (block.frames() < kRecordedFramesPerBlock) {
        if (jointsNext() && isDue(*joints)) {
            deliver(*joints, stop);
            if (const core::Expected<void> done = joints->advance(); !done)
                return done;
        } else if (!array.atEnd() && !jointsNext() && isDue(array)) {
            // A jump can only be told at the beginning of a block.
            if (block.frames() > 0 && array.jumps())
                break;
            append(block, array);
            if (const core::Expected<void> done = array.advance(); !done)
                return done;
        } else {
            break;
        }
        if (stop.stop_requested())
            return {};
    }
    if (block.frames() > 0)
        deliver(block, stop);
    else if (joints != nullptr && m_consumer != nullptr)
        m_consumer->notify();
    return {};
}

void RecordedWorker::append(core::SampleBlock& block, const RecordedTrack& array) {
    const auto values = array.values<float>();
    block.channels = values.size();
    block.discontinuity = block.discontinuity || m_jumped || array.jumps();
    m_jumped = false;
    block.time_ns.push_back(due_ns(array.time_ns()));
    block.sourceTime_s.push_back(static_cast<double>(array.time_ns() - m_start_ns) / 1e9);
    block.values.insert(block.values.end(), values.begin(), values.end());
    m_shown_ns.set(array.time_ns());
}

void RecordedWorker::deliver(core::SampleBlock& block, const std::stop_token& stop) {
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

void RecordedWorker::deliver(const RecordedTrack& joints, const std::stop_token& stop) {
    core::JointSample sample = jointSample(joints.values<double>());
    sample.time_ns = due_ns(joints.time_ns());
    sample.sourceTime_s = static_cast<double>(joints.time_ns() - m_start_ns) / 1e9;
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
    m_outlet.setState(state, now_ns(), std::move(message));
}

void RecordedWorker::loseBy(core::Error error) {
    std::string message = describe(error);
    m_error.set(std::move(error));
    endAs(core::DeviceState::lost, std::move(message));
}

void RecordedWorker::anchorAt(std::int64_t time_ns) {
    m_anchor_ns = now_ns();
    m_anchorTime_ns = time_ns;
}

std::int64_t RecordedWorker::due_ns(std::int64_t time_ns) const {
    // Bounded: a gap in a recording may be longer than the clock can count.
    constexpr double kLongest_ns = 4e18;
    const double speed = std::isinf(m_active.speed) ? 1.0 : m_active.speed;
    const double wait_ns = static_cast<double>(time_ns - m_anchorTime_ns) / speed;
    return m_anchor_ns + static_cast<std::int64_t>(std::clamp(wait_ns, -kLongest_ns, kLongest_ns));
}

} // namespace teleta::replay
