// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/recording/recording.h"
#include "devices/replay/playback_desk.h"
#include "devices/replay/recorded_config.h"
#include "devices/replay/recorded_outlet.h"
#include "devices/replay/recorded_references.h"
#include "devices/replay/recorded_track.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::replay {

/// What a worker has to know of a recording beforehand.
struct RecordedFacts {
    struct Mark {
        std::int64_t time_ns = 0;
        std::string text;
    };
    recording::Recording::Extent extent; ///< of the stream
    std::int64_t start_ns = 0;           ///< of the recording
    std::vector<Mark> marks;             ///< in order of time
};

/// Plays an array of a recording and the joints of the arm that wears it, in step, or a camera.
///   due = anchor + (time of the frame - time at the anchor) / speed
/// A frame's time_ns is when it was due, so that frames keep their order and distance; its source time is
/// that since the recording's start.
/// Thread: run() is the worker's, open() before it; wake() and position() from any; the commands from one
/// controlling thread.
class RecordedWorker {
public:
    RecordedWorker(RecordedConfig config, RecordedFacts facts);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake();

    void play();
    void pause();
    void step(int frames);
    void setSpeed(double factor);
    void seek(double time_s);
    void setLoop(bool loop);
    [[nodiscard]] core::PlaybackPosition position() const;

    [[nodiscard]] std::vector<core::PlaybackMark> marks() const;

    /// Of a camera, a RecordedCameraOutlet, otherwise a RecordedArrayOutlet.
    [[nodiscard]] RecordedOutlet& outlet() { return *m_outlet; }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() { return m_joints; }
    [[nodiscard]] core::DeviceStatus jointStatus() const;
    [[nodiscard]] const RecordedConfig& config() const { return m_config; }
    /// Blocks of the array and the joints that were passed over because they are damaged. Any thread.
    [[nodiscard]] std::uint64_t damagedBlocks() const { return m_damagedBlocks.load(); }
    /// Why it is lost. Any thread.
    [[nodiscard]] core::Error error() const { return m_error.get(); }

private:
    void play(RecordedTrack& frames, RecordedTrack* joints, const std::stop_token& stop);
    /// at_ns: when what is played from there begins.
    [[nodiscard]] core::Expected<void> seekTo(RecordedTrack& frames, RecordedTrack* joints, double time_s,
                                              std::int64_t at_ns, const std::stop_token& stop);
    [[nodiscard]] core::Expected<void> stepBy(RecordedTrack& frames, RecordedTrack* joints, long long by,
                                              const std::stop_token& stop);
    [[nodiscard]] core::Expected<void> show(RecordedTrack& frames, RecordedTrack* joints,
                                            std::int64_t time_ns, std::int64_t at_ns,
                                            const std::stop_token& stop);
    [[nodiscard]] core::Expected<void> playDue(RecordedTrack& frames, RecordedTrack* joints,
                                               const std::stop_token& stop);
    [[nodiscard]] core::Expected<void> playEnd(RecordedTrack& frames, RecordedTrack* joints,
                                               const std::stop_token& stop);
    void take(const RecordedTrack& frames);
    void deliver(const std::stop_token& stop);
    void deliver(const RecordedTrack& joints, const std::stop_token& stop);
    void endAs(core::DeviceState state, std::string message = {});
    void loseBy(core::Error error);
    void countDamage(const RecordedTrack& frames, const RecordedTrack* joints);
    void anchorAt(std::int64_t time_ns, std::int64_t at_ns);
    [[nodiscard]] std::int64_t due_ns(std::int64_t time_ns) const;
    /// When the newest commands take effect: as soon as they were given, so that what is played together is
    /// together; of what waited too long, now.
    [[nodiscard]] std::int64_t commanded_ns() const;
    /// The time that is played now, when it goes on from where it was with another speed.
    [[nodiscard]] std::int64_t reached_ns(const PlaybackCommands& previous, std::int64_t now_ns) const;
    [[nodiscard]] double period_ns() const;
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }

    RecordedConfig m_config;
    RecordedFacts m_facts;
    RecordedConfig::Span m_span; ///< that is played
    std::unique_ptr<RecordedOutlet> m_outlet;
    core::BoundedQueue<core::JointSample> m_joints;
    core::LatestCopy<std::int64_t> m_shown_ns; ///< time that was played up to

    core::LatestCopy<core::Error> m_error;
    std::atomic<std::uint64_t> m_damagedBlocks{0};

    PlaybackDesk m_desk;

    // The worker's own.
    core::Wakeup* m_consumer = nullptr;
    std::unique_ptr<RecordedReferences> m_references; ///< while it runs
    PlaybackCommands m_active;
    bool m_jumped = true; ///< before the next frame
    bool m_jointsJumped = true;
    std::int64_t m_anchor_ns = 0;
    std::int64_t m_anchorTime_ns = 0;
    std::atomic<std::uint64_t> m_jointsRead{0};
    std::uint64_t m_jointOverflowAtOpen = 0;
};

} // namespace teleta::replay
