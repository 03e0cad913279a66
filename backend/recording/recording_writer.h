// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/core/error.h"
#include "backend/recording/recording_database.h"
#include "backend/recording/recording_types.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace teleta::recording {

/// Collects frames and events and writes them, one transaction at a time.
/// Thread: one.
class RecordingWriter {
public:
    RecordingWriter(std::string path, std::function<QDateTime()> utcNow, bool simulatedTime);
    /// Of frames that were recorded before, elsewhere. anchors: as they were then; empty: not known.
    RecordingWriter(std::string path, std::vector<TimeAnchor> anchors);

    /// Creates the file and writes its head. On failure the file is removed.
    [[nodiscard]] core::Expected<void> begin(const RecordingHead& head);

    /// The next stream; they are counted from 0.
    [[nodiscard]] core::Expected<void> addStream(const StreamInfo& info);
    /// Frames of the wrong shape, or with times that a reader would refuse, are dropped. Frames older than
    /// their predecessors are a jump.
    void take(std::size_t stream, core::TappedFrames&& frames);
    /// Total frames of the stream that were dropped on their way here. Each increase is recorded as an event.
    void setDropped(std::size_t stream, std::uint64_t frames);
    void take(RecordingEvent event);
    void take(MarkChange change);

    /// Writes what was taken since the last commit: all or nothing.
    [[nodiscard]] core::Expected<void> commit();
    /// After the last commit: merges the write-ahead log.
    [[nodiscard]] core::Expected<void> finish();

    [[nodiscard]] std::uint64_t frames() const { return m_frames; }
    /// Of all streams, on their way and here.
    [[nodiscard]] std::uint64_t dropped() const;
    /// Bytes of the frames that wait for the next commit.
    [[nodiscard]] std::size_t waitingBytes() const { return m_waitingBytes; }
    [[nodiscard]] std::uint64_t marks() const { return m_marks; }
    /// Time of the newest frame that was taken.
    [[nodiscard]] std::int64_t newest_ns() const { return m_newest_ns; }
    /// On the disk, with the log.
    [[nodiscard]] std::uint64_t bytes() const;

private:
    struct Stream {
        StreamInfo info;
        long long key = 0;
        std::uint64_t refused = 0;              ///< by take()
        std::uint64_t dropped = 0;              ///< with the refused ones
        std::vector<core::TappedFrames> blocks; ///< to be written
        std::optional<std::int64_t> newest_ns;
    };

    [[nodiscard]] core::Expected<void> writeAll();
    [[nodiscard]] core::Expected<void> writeBlock(const Stream& stream, const core::TappedFrames& block);
    [[nodiscard]] core::Expected<void> writeAnchor();
    [[nodiscard]] core::Expected<void> insertAnchor(const TimeAnchor& anchor);

    RecordingDatabase m_database;
    std::function<QDateTime()> m_utcNow;
    std::vector<TimeAnchor> m_given; ///< instead of those of the wall clock
    bool m_simulatedTime;
    std::int64_t m_start_ns = 0;
    std::int64_t m_newest_ns = 0;
    std::optional<QSqlQuery> m_insertBlock;
    std::vector<Stream> m_streams;
    std::vector<RecordingEvent> m_events;
    std::vector<MarkChange> m_markChanges; ///< in the order in which they were asked for
    std::optional<TimeAnchor> m_anchor;
    std::size_t m_waitingBytes = 0;
    std::uint64_t m_frames = 0;
    std::uint64_t m_marks = 0;
};

} // namespace teleta::recording
