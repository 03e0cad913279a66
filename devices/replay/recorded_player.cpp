// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::replay {

namespace {

/// The first frame after a time that was asked for is shown for it if it comes within this time.
constexpr double kShortGap_ns = 50e6;
/// A worker that is later than this does not catch up.
constexpr std::int64_t kLongestLag_ns = 500'000'000;
/// A gap in a recording may be longer than the clock can count.
constexpr double kLongest_ns = 4e18;

double toS(std::int64_t duration_ns) {
    return static_cast<double>(duration_ns) * 1e-9;
}

std::unique_ptr<PlaybackOutlet> makeOutlet(const PlaybackConfig& config) {
    if (config.camera)
        return std::make_unique<CameraPlaybackOutlet>(config.queuePictures);
    if (config.jointsAlone)
        return std::make_unique<JointPlaybackOutlet>(config.queueJoints);
    return std::make_unique<ArrayPlaybackOutlet>(config.queueBlocks);
}

} // namespace

core::Expected<std::shared_ptr<RecordedPlayer>> RecordedPlayer::open(RecordedConfig config) {
    TELETA_TRY(auto recording, openTeletaRecording(config));
    config.hasWrench = config.wrenchStream.has_value();
    return std::make_shared<RecordedPlayer>(std::move(config), std::move(recording));
}

core::Expected<std::shared_ptr<RecordedPlayer>> RecordedPlayer::open(CsvConfig config) {
    TELETA_TRY(auto recording, openCsvRecording(config));
    return std::make_shared<RecordedPlayer>(std::move(config), std::move(recording));
}

RecordedPlayer::RecordedPlayer(PlaybackConfig config, std::unique_ptr<PlaybackRecording> recording)
    : m_config(std::move(config))
    , m_recording(std::move(recording))
    , m_outlet(makeOutlet(m_config))
    , m_joints(m_config.queueJoints)
    , m_wrenches(m_config.hasWrench ? m_config.queueJoints : 1)
    , m_temperatures(m_config.chips > 0 ? m_config.queueJoints : 1)
    , m_box(m_config.clock, m_config.autoplay, m_config.loop, m_config.speed)
    , m_startsQuietly(m_config.startsQuietly) {
    m_shown.set({spanOf(m_recording->extent()).first_ns});
}

void RecordedPlayer::start(core::Wakeup& consumer) {
    m_thread.start(consumer);
    m_recording->startIndexing();
}

void RecordedPlayer::stop() {
    m_thread.stop();
    m_recording->stopIndexing();
}

void RecordedPlayer::open(core::Wakeup& consumer) {
    m_consumer = &consumer;
    m_outlet->open(consumer, now_ns());
    m_jointsRead.store(0);
    m_jointOverflowAtOpen = m_joints.overflow();
    m_box.begin(m_config.autoplay);
}

PlaybackConfig::Span RecordedPlayer::spanOf(const PlaybackExtent& extent) const {
    return m_config.span.value_or(PlaybackConfig::Span{extent.first_ns, extent.last_ns});
}

core::PlaybackPosition RecordedPlayer::position() const {
    core::PlaybackPosition position;
    const std::optional<double> sought_s = m_box.describe(position);
    const Shown shown = m_shown.get();
    const PlaybackExtent extent = m_recording->extent();
    const PlaybackConfig::Span span = spanOf(extent);
    const double since_ns = static_cast<double>(shown.time_ns - extent.first_ns);
    position.time_s = toS(shown.time_ns - span.first_ns);
    position.duration_s = std::max(toS(span.last_ns - span.first_ns), position.time_s);
    position.frames = std::max(extent.frames, shown.frame.value_or(0) + 1);
    if (shown.frame)
        position.frame = *shown.frame;
    else if (extent.period_ns > 0.0 && since_ns > 0.0)
        position.frame = std::min(static_cast<std::uint64_t>(std::llround(since_ns / extent.period_ns)),
                                  position.frames - 1);
    position.indexed = extent.complete;
    position.damagedBlocks = damagedBlocks();
    position.target_s = std::min(sought_s.value_or(position.time_s), position.duration_s);
    return position;
}

std::vector<core::PlaybackMark> RecordedPlayer::marks() const {
    const std::int64_t first_ns = spanOf(m_recording->extent()).first_ns;
    std::vector<core::PlaybackMark> marks;
    for (const PlaybackRecording::Mark& mark : m_recording->marks())
        marks.push_back({toS(mark.time_ns - first_ns), mark.sourceTime_s, mark.text});
    return marks;
}

core::DeviceStatus RecordedPlayer::jointStatus() const {
    core::DeviceStatus status = m_outlet->status();
    status.framesRead = m_jointsRead.load();
    status.framesLost = m_joints.overflow() - m_jointOverflowAtOpen;
    const bool runs = status.state == core::DeviceState::live;
    const double speed = position().speed;
    status.rate_Hz = runs && std::isfinite(speed) ? m_config.arm.nominalRate_Hz * speed : 0.0;
    return status;
}

void RecordedPlayer::run(const std::stop_token& stop) {
    m_stop = stop;
    // A database belongs to the thread that opened it.
    core::Expected<PlaybackTracks> tracks =
        m_recording->openTracks([this] { return m_stop.stop_requested() || m_box.isSeekWaiting(); });
    if (tracks) {
        m_tracks = std::move(*tracks);
        play();
        const PlaybackTracks closed = std::move(m_tracks); // the recording goes last
    } else {
        loseBy(tracks.error());
        while (!m_stop.stop_requested()) {
            (void)m_box.take();
            m_box.waitUntil(core::PacingClock::kNever_ns, m_stop);
        }
    }
    m_outlet->setState(core::DeviceState::closed, now_ns());
}

void RecordedPlayer::play() {
    while (!m_stop.stop_requested()) {
        const PlaybackCommands previous = std::exchange(m_active, m_box.take());
        const core::DeviceState state = m_outlet->state();
        const bool ended = state == core::DeviceState::finished || state == core::DeviceState::lost;
        core::Expected<void> done = obey(previous, ended);
        countDamage();
        if (done && !m_active.playing) {
            if (!ended || m_active.seek_s)
                m_outlet->setState(core::DeviceState::paused, now_ns());
            m_box.waitUntil(core::PacingClock::kNever_ns, m_stop);
            continue;
        }
        if (done)
            done = playDue();
        if (!done && done.error().kind != core::ErrorKind::cancelled) {
            // What came before the error is not lost.
            if (m_outlet->taken() > 0)
                deliver();
            loseBy(done.error());
        }
        countDamage();
    }
}

core::Expected<void> RecordedPlayer::obey(const PlaybackCommands& previous, bool ended) {
    if (m_active.seek_s || (ended && m_active.playing)) {
        TELETA_CHECK(seekTo(m_active.seek_s.value_or(0.0), commanded_ns()));
    } else if (previous.playing != m_active.playing || previous.speed != m_active.speed) {
        const std::int64_t at_ns = previous.playing ? now_ns() : commanded_ns();
        const std::int64_t reached = reached_ns(previous, at_ns);
        anchorAt(reached, at_ns);
        // Sources that are played together stand at one time, whenever the last frame of each was.
        if (m_config.span)
            m_shown.set({std::min(reached, m_config.span->last_ns)});
        // As fast as possible, frames run ahead of the clock.
        if (std::isinf(previous.speed))
            m_jumped = m_jointsJumped = m_temperaturesJumped = true;
    }
    return m_active.steps != 0 ? stepBy(m_active.steps) : core::Expected<void>();
}

void RecordedPlayer::countDamage() {
    std::uint64_t damaged = 0;
    for (const PlaybackTrack* track :
         {m_tracks.frames.get(), m_tracks.joints.get(), m_tracks.wrench.get(), m_tracks.temperatures.get()})
        damaged += track != nullptr ? track->damagedBlocks() : 0;
    m_damagedBlocks.store(damaged);
}

core::Expected<void> RecordedPlayer::seekTo(double time_s, std::int64_t at_ns) {
    PlaybackTrack& frames = *m_tracks.frames;
    const PlaybackExtent extent = m_recording->extent();
    const PlaybackConfig::Span span = spanOf(extent);
    const bool isWithin = time_s < toS(span.last_ns - span.first_ns) || !extent.complete;
    const std::int64_t wanted_ns =
        isWithin ? span.first_ns + std::llround(std::min(time_s * 1e9, kLongest_ns)) : span.last_ns;
    // Sources that are played together may end later than this one, whose last frame is then shown.
    TELETA_CHECK(frames.seek(extent.complete ? std::min(wanted_ns, extent.last_ns) : wanted_ns));
    if (frames.atEnd()) // the time is behind the end, or the last block is damaged
        TELETA_CHECK(frames.back(1));
    if (frames.atEnd()) // nothing can be read
        return waitFrom(wanted_ns, at_ns);
    m_jumped = !std::exchange(m_startsQuietly, false);
    if (!m_config.span)
        return show(frames.time_ns(), at_ns);
    // Sources that are played together have frames at other times: all go on from the time asked for.
    const double gap_ns = std::max(2.0 * extent.period_ns, kShortGap_ns);
    const std::int64_t ahead_ns = frames.time_ns() - wanted_ns;
    if (ahead_ns > 0 && (m_active.playing || static_cast<double>(ahead_ns) > gap_ns))
        return waitFrom(wanted_ns, at_ns);
    const core::Expected<void> shown = show(std::max(frames.time_ns(), wanted_ns), at_ns);
    m_shown.set({wanted_ns});
    return shown;
}

core::Expected<void> RecordedPlayer::waitFrom(std::int64_t time_ns, std::int64_t at_ns) {
    m_jointsJumped = m_temperaturesJumped = true;
    anchorAt(time_ns, at_ns);
    m_shown.set({time_ns});
    return seekBeside(time_ns);
}

core::Expected<void> RecordedPlayer::seekBeside(std::int64_t time_ns) {
    if (m_tracks.joints)
        TELETA_CHECK(m_tracks.joints->seek(time_ns));
    for (PlaybackTrack* track : {m_tracks.wrench.get(), m_tracks.temperatures.get()}) {
        if (track == nullptr)
            continue;
        // What was measured last at that time is known then.
        TELETA_CHECK(track->seek(time_ns));
        TELETA_CHECK(track->back(1));
    }
    return {};
}

core::Expected<void> RecordedPlayer::stepBy(long long by) {
    // The track stands at the frame behind the one that is shown.
    PlaybackTrack& frames = *m_tracks.frames;
    if (by < 0) {
        TELETA_TRY(const std::uint64_t moved, frames.back(static_cast<std::uint64_t>(-by) + 1));
        if (moved < 2) // the first one is shown already
            return moved == 0 ? core::Expected<void>() : frames.advance();
    } else {
        if (frames.atEnd())
            return {};
        for (long long i = 1; i < by && !frames.atEnd() && !m_stop.stop_requested(); ++i)
            TELETA_CHECK(frames.advance());
        if (frames.atEnd())
            TELETA_CHECK(frames.back(1));
    }
    m_jumped = m_jumped || by != 1;
    return show(frames.time_ns(), now_ns());
}

/// Delivers the current frame now, as that of this time, also when paused.
core::Expected<void> RecordedPlayer::show(std::int64_t time_ns, std::int64_t at_ns) {
    TELETA_CHECK(seekBeside(time_ns));
    if (m_tracks.joints) // the arm is where it was last, also when nothing goes on
        TELETA_CHECK(m_tracks.joints->back(1));
    m_jointsJumped = m_temperaturesJumped = true;
    anchorAt(time_ns, at_ns);
    TELETA_CHECK(deliverBeside(time_ns));
    TELETA_CHECK(playUpTo(m_tracks.joints.get(), time_ns, [this](const PlaybackTrack&) { deliverJoints(); }));
    take();
    m_shown.set({time_ns, m_tracks.frames->frame()});
    deliver();
    return m_tracks.frames->advance();
}

core::Expected<void> RecordedPlayer::playEnd() {
    const bool unpaced = std::isinf(m_active.speed);
    const Shown shown = m_shown.get();
    const PlaybackExtent extent = m_recording->extent();
    const PlaybackConfig::Span span = spanOf(extent);
    const std::int64_t last_ns = std::max(span.last_ns, shown.time_ns); // the index may be behind
    // Sources that are played together end together, whatever the period of each.
    const std::int64_t seam_ns = m_active.loop && !m_config.span ? std::llround(extent.period_ns) : 0;
    const std::int64_t end_ns = due_ns(last_ns + seam_ns);
    if (!unpaced && now_ns() < end_ns) {
        m_outlet->setState(core::DeviceState::live, now_ns());
        m_box.waitUntil(end_ns, m_stop);
        return {};
    }
    // Without any duration it would start over endlessly.
    if (m_active.loop && last_ns + seam_ns > span.first_ns) {
        // The next pass begins when this one ended, not when that was noticed: sources that are played
        // together notice it at different times.
        const std::int64_t now = now_ns();
        const bool isLate = unpaced || now - end_ns > kLongestLag_ns;
        return seekTo(0.0, isLate ? now : end_ns);
    }
    TELETA_CHECK(deliverBeside(last_ns));
    m_shown.set({last_ns, shown.frame});
    endAs(core::DeviceState::finished);
    return {};
}

core::Expected<void> RecordedPlayer::playDue() {
    PlaybackTrack& frames = *m_tracks.frames;
    PlaybackTrack* joints = m_tracks.joints.get();
    const bool unpaced = std::isinf(m_active.speed);
    const auto hasJoints = [&] { return joints != nullptr && !joints->atEnd(); };
    const auto jointsNext = [&] {
        return hasJoints() && (frames.atEnd() || joints->time_ns() <= frames.time_ns());
    };
    if (frames.atEnd() && !hasJoints())
        return playEnd();
    const std::int64_t first_ns = jointsNext() ? joints->time_ns() : frames.time_ns();
    const std::int64_t now = now_ns();
    if (!unpaced) {
        const std::int64_t next_ns = due_ns(first_ns);
        if (now < next_ns) {
            m_outlet->setState(core::DeviceState::live, now);
            m_box.waitUntil(next_ns, m_stop);
            return {};
        }
        if (now - next_ns > kLongestLag_ns)
            anchorAt(first_ns, now);
    }
    const auto isDue = [&](const PlaybackTrack& track) { return unpaced || due_ns(track.time_ns()) <= now; };
    // Joints first, up to the newest frame of the block: a skin frame that was read before them is then
    // there.
    const double since_ns = static_cast<double>(now - m_anchor_ns) * (unpaced ? 0.0 : m_active.speed);
    const std::int64_t reached_ns = std::min<std::int64_t>(m_anchorTime_ns + std::llround(since_ns),
                                                           spanOf(m_recording->extent()).last_ns);
    TELETA_CHECK(deliverBeside(std::max(first_ns, reached_ns)));
    while (!m_outlet->isFull()) {
        if (jointsNext() && isDue(*joints)) {
            deliverJoints();
            TELETA_CHECK(joints->advance());
        } else if (!frames.atEnd() && !jointsNext() && isDue(frames)) {
            // A jump can only be told at the beginning of a block.
            if (m_outlet->taken() > 0 && frames.jumps())
                break;
            take();
            TELETA_CHECK(frames.advance());
        } else {
            break;
        }
        if (m_stop.stop_requested())
            return {};
    }
    if (m_outlet->taken() > 0)
        deliver();
    else if (joints != nullptr && m_consumer != nullptr)
        m_consumer->notify();
    return {};
}

void RecordedPlayer::take() {
    const PlaybackTrack& frames = *m_tracks.frames;
    const std::int64_t time_ns = frames.time_ns();
    const bool jumped = std::exchange(m_jumped, false) || frames.jumps();
    m_outlet->take(frames, {.time_ns = std::max(due_ns(time_ns), m_anchor_ns),
                            .jumped = jumped,
                            .reference = m_tracks.referenceAt(time_ns)});
    m_shown.set({time_ns, frames.frame()});
}

void RecordedPlayer::deliver() {
    const core::DeviceState state = m_active.playing ? core::DeviceState::live : core::DeviceState::paused;
    while (!m_outlet->deliver(state, std::isinf(m_active.speed))) {
        if (!m_box.waitForRoom(m_stop))
            return;
    }
}

void RecordedPlayer::deliverJoints() {
    const PlaybackTrack& joints = *m_tracks.joints;
    const bool jumped = std::exchange(m_jointsJumped, false) || joints.jumps();
    core::JointSample sample = jointSampleAt(joints, {.time_ns = due_ns(joints.time_ns()), .jumped = jumped});
    m_jointsRead.fetch_add(1, std::memory_order_relaxed);
    give(m_joints, std::move(sample));
}

core::Expected<void> RecordedPlayer::deliverBeside(std::int64_t upTo_ns) {
    TELETA_CHECK(playUpTo(m_tracks.wrench.get(), upTo_ns, [this](const PlaybackTrack& wrench) {
        give(m_wrenches, wrenchSampleAt(wrench, due_ns(wrench.time_ns())));
    }));
    return playUpTo(m_tracks.temperatures.get(), upTo_ns, [this](const PlaybackTrack& warm) {
        const bool jumped = std::exchange(m_temperaturesJumped, false) || warm.jumps();
        give(m_temperatures,
             temperatureSampleAt(warm, {.time_ns = due_ns(warm.time_ns()), .jumped = jumped}));
    });
}

template <typename Give>
core::Expected<void> RecordedPlayer::playUpTo(PlaybackTrack* track, std::int64_t upTo_ns, const Give& give) {
    while (track != nullptr && !track->atEnd() && track->time_ns() <= upTo_ns && !m_stop.stop_requested()) {
        give(*track);
        TELETA_CHECK(track->advance());
    }
    return {};
}

template <typename Sample>
void RecordedPlayer::give(core::BoundedQueue<Sample>& queue, Sample sample) {
    if (!std::isinf(m_active.speed)) {
        queue.push(std::move(sample));
        return;
    }
    while (!queue.tryPush(sample)) {
        m_consumer->notify();
        if (!m_box.waitForRoom(m_stop))
            return;
    }
}

void RecordedPlayer::endAs(core::DeviceState state, std::string message) {
    m_active.playing = false;
    m_box.end();
    m_outlet->setState(state, now_ns(), std::move(message));
}

void RecordedPlayer::loseBy(core::Error error) {
    std::string message = describe(error);
    m_error.set(std::move(error));
    endAs(core::DeviceState::lost, std::move(message));
}

void RecordedPlayer::anchorAt(std::int64_t time_ns, std::int64_t at_ns) {
    m_anchor_ns = at_ns;
    m_anchorTime_ns = time_ns;
}

std::int64_t RecordedPlayer::due_ns(std::int64_t time_ns) const {
    const double speed = std::isinf(m_active.speed) ? 1.0 : m_active.speed;
    const double wait_ns = static_cast<double>(time_ns - m_anchorTime_ns) / speed;
    return m_anchor_ns + static_cast<std::int64_t>(std::clamp(wait_ns, -kLongest_ns, kLongest_ns));
}

std::int64_t RecordedPlayer::commanded_ns() const {
    const std::int64_t now = now_ns();
    return now - m_active.at_ns > kLongestLag_ns ? now : m_active.at_ns;
}

std::int64_t RecordedPlayer::reached_ns(const PlaybackCommands& previous, std::int64_t now_ns) const {
    const std::int64_t shown_ns = m_shown.get().time_ns;
    if (!previous.playing || std::isinf(previous.speed))
        return shown_ns;
    // Frames of the sources played together with it do not count: they were shown at other times.
    const double played_ns = static_cast<double>(now_ns - m_anchor_ns) * previous.speed;
    return std::max<std::int64_t>(shown_ns, m_anchorTime_ns + std::llround(played_ns));
}

} // namespace teleta::replay
