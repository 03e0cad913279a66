// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/chip_thermometers.h"
#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/latest_copy.h"
#include "devices/replay/playback_command_box.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/playback_outlet.h"
#include "devices/replay/playback_recording.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::replay {

/// Plays the frames of a recording: an array and the joints of the arm that wears it, in step, a camera, or
/// the joints of an arm alone.
///   due = anchor + (time of the frame - time at the anchor) / speed
/// The anchor is set anew by play, seek, step, a change of speed and at the seam of a loop. A frame's time_ns
/// is when it was due, so that frames keep their order and distance.
/// States:
///   connecting -> live <-> paused -> finished; unreadable: lost, with the place; stop(): closed
/// At a finite speed a full queue loses frames, as it would with a device; at infinity playing waits for the
/// consumer. A playback that is finished or lost starts over with play(), and can still be searched.
/// Thread: start and stop from one controlling thread; the rest from any.
class RecordedPlayer {
public:
    /// Error: as openTeletaRecording.
    [[nodiscard]] static core::Expected<std::shared_ptr<RecordedPlayer>> open(RecordedConfig config);
    /// The array is described by the file. Error: as openCsvRecording.
    [[nodiscard]] static core::Expected<std::shared_ptr<RecordedPlayer>> open(CsvConfig config);

    RecordedPlayer(PlaybackConfig config, std::unique_ptr<PlaybackRecording> recording);
    ~RecordedPlayer() { stop(); }
    RecordedPlayer(const RecordedPlayer&) = delete;
    RecordedPlayer& operator=(const RecordedPlayer&) = delete;

    void start(core::Wakeup& consumer);
    void stop();

    [[nodiscard]] PlaybackCommandBox& commands() { return m_box; }
    [[nodiscard]] core::PlaybackPosition position() const;
    [[nodiscard]] std::vector<core::PlaybackMark> marks() const;

    /// A CameraPlaybackOutlet for a camera, a JointPlaybackOutlet for an arm alone, otherwise an
    /// ArrayPlaybackOutlet.
    [[nodiscard]] PlaybackOutlet& outlet() { return *m_outlet; }
    /// Of the arm that wears the array.
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() { return m_joints; }
    [[nodiscard]] core::DeviceStatus jointStatus() const;
    /// Of the sensor at the arm's wrist, up to the newest joint sample; null: the recording has none.
    [[nodiscard]] core::BoundedQueue<core::WrenchSample>* wrenches() {
        return m_config.hasWrench ? &m_wrenches : nullptr;
    }
    /// Of the array's chips, up to its newest frame.
    [[nodiscard]] core::BoundedQueue<core::TemperatureSample>& temperatures() { return m_temperatures; }
    [[nodiscard]] const PlaybackConfig& config() const { return m_config; }
    /// Blocks of the array and of what is played with it that were skipped because they are damaged.
    [[nodiscard]] std::uint64_t damagedBlocks() const { return m_damagedBlocks.load(); }
    /// Why it is lost.
    [[nodiscard]] core::Error error() const { return m_error.get(); }

private:
    friend core::DeviceThread<RecordedPlayer>;
    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_box.wake(); }

    struct Shown {
        std::int64_t time_ns = 0;
        std::optional<std::uint64_t> frame = std::nullopt; ///< where the format numbers its frames
    };

    void play();
    /// Carries out the commands that were taken, in place of these.
    [[nodiscard]] core::Expected<void> obey(const PlaybackCommands& previous, bool ended);
    /// at_ns: when playing from there begins.
    [[nodiscard]] core::Expected<void> seekTo(double time_s, std::int64_t at_ns);
    /// Nothing is shown until a time after this one.
    [[nodiscard]] core::Expected<void> waitFrom(std::int64_t time_ns, std::int64_t at_ns);
    [[nodiscard]] core::Expected<void> stepBy(long long by);
    [[nodiscard]] core::Expected<void> show(std::int64_t time_ns, std::int64_t at_ns);
    [[nodiscard]] core::Expected<void> playDue();
    [[nodiscard]] core::Expected<void> playEnd();
    void take();
    void deliver();
    void deliverJoints();
    /// The forces and temperatures that were read up to this time of the recording.
    [[nodiscard]] core::Expected<void> deliverBeside(std::int64_t upTo_ns);
    /// Plays a track up to this time. give: takes what it stands at.
    template <typename Give>
    [[nodiscard]] core::Expected<void> playUpTo(PlaybackTrack* track, std::int64_t upTo_ns, const Give& give);
    /// Puts the sample into a queue of the consumer; as fast as possible, it waits until there is room.
    template <typename Sample>
    void give(core::BoundedQueue<Sample>& queue, Sample sample);
    /// Moves the tracks beside the frames.
    [[nodiscard]] core::Expected<void> seekBeside(std::int64_t time_ns);
    void endAs(core::DeviceState state, std::string message = {});
    void loseBy(core::Error error);
    void countDamage();
    void anchorAt(std::int64_t time_ns, std::int64_t at_ns);
    [[nodiscard]] std::int64_t due_ns(std::int64_t time_ns) const;
    /// When the newest commands take effect: when they were given, so that sources that are played together
    /// stay together; now if they waited too long.
    [[nodiscard]] std::int64_t commanded_ns() const;
    /// The time that is played now, from which it goes on at another speed.
    [[nodiscard]] std::int64_t reached_ns(const PlaybackCommands& previous, std::int64_t now_ns) const;
    [[nodiscard]] PlaybackConfig::Span spanOf(const PlaybackExtent& extent) const;
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }

    PlaybackConfig m_config;
    std::unique_ptr<PlaybackRecording> m_recording;
    std::unique_ptr<PlaybackOutlet> m_outlet;
    core::BoundedQueue<core::JointSample> m_joints;
    core::BoundedQueue<core::WrenchSample> m_wrenches;
    core::BoundedQueue<core::TemperatureSample> m_temperatures;
    core::LatestCopy<Shown> m_shown; ///< what was played up to
    core::LatestCopy<core::Error> m_error;
    std::atomic<std::uint64_t> m_damagedBlocks{0};
    std::atomic<std::uint64_t> m_jointsRead{0};
    PlaybackCommandBox m_box;

    // The worker's own.
    core::Wakeup* m_consumer = nullptr;
    std::stop_token m_stop;
    PlaybackTracks m_tracks; ///< while it runs
    PlaybackCommands m_active;
    bool m_startsQuietly;
    bool m_jumped = true; ///< before the next frame
    bool m_jointsJumped = true;
    bool m_temperaturesJumped = true;
    std::int64_t m_anchor_ns = 0;
    std::int64_t m_anchorTime_ns = 0;
    std::uint64_t m_jointOverflowAtOpen = 0;

    core::DeviceThread<RecordedPlayer> m_thread{*this};
};

} // namespace teleta::replay
