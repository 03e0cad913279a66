// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/core/error.h"
#include "backend/recording/recording_types.h"

#include <QtGlobal>

#include <compare>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

class QSqlQuery;

namespace teleta::recording {

class RecordingDatabase;

/// The number values of one frame of a block.
template <typename Number>
[[nodiscard]] std::span<const Number> valuesOf(const core::TappedFrames& block, std::size_t frame,
                                               std::size_t channels) {
    return std::span(reinterpret_cast<const Number*>(block.values.data()), block.frames() * channels)
        .subspan(frame * channels, channels);
}

/// Reads the blocks of one stream in order of time. Must not outlive its Recording.
/// Thread: the recording's.
class StreamReader {
public:
    StreamReader(StreamReader&&) = default;
    StreamReader& operator=(StreamReader&&) = default;

    /// The next block; false after the last one, and block is unchanged then. Error: badInput for a damaged
    /// block or file, ioFailed. After a damaged block (also one on an unreadable page of the file) call it
    /// again for the one after it.
    [[nodiscard]] core::Expected<bool> next(core::TappedFrames& block);

    /// The undamaged block before the one that was read last; false before the first one. next() continues
    /// from there. Error: badInput for a damaged file, ioFailed.
    [[nodiscard]] core::Expected<bool> previous(core::TappedFrames& block);

    /// Whether next() can continue after its error.
    [[nodiscard]] bool canGoOn() const { return m_canGoOn; }

    /// The next block is the one that holds the first frame at or after a time, or the last one before it.
    [[nodiscard]] core::Expected<void> seek(std::int64_t time_ns);

private:
    friend class Recording;
    /// Blocks are in the order of their first time and their key.
    struct Position {
        qlonglong first_ns = std::numeric_limits<qlonglong>::min();
        qlonglong key = 0;
        auto operator<=>(const Position&) const = default;
    };

    StreamReader(std::shared_ptr<RecordingDatabase> database, StreamInfo info, long long key);
    [[nodiscard]] core::Expected<QSqlQuery> select(const char* columns, const char* rule,
                                                   const Position& from) const;
    /// Of the first block by a rule, from the index alone; empty: there is none, or the index is damaged.
    [[nodiscard]] std::optional<Position> place(const char* rule, const Position& from) const;
    [[nodiscard]] core::Unexpected passOver(core::Unexpected error);
    [[nodiscard]] bool readRow(const QSqlQuery& query, core::TappedFrames& block);

    std::shared_ptr<RecordingDatabase> m_database;
    StreamInfo m_info;
    long long m_key;
    std::shared_ptr<QSqlQuery> m_query; ///< for one block; active only while it is read
    Position m_after;                   ///< the next block is the first one after it
    Position m_at;                      ///< of the block that was read last, or was sought
    bool m_canGoOn = true;
};

/// A recording, opened for reading. Thread: the one that opened it.
class Recording {
public:
    /// Error: as RecordingDatabase::openForReading; badInput: the recording was never started.
    [[nodiscard]] static core::Expected<Recording> open(const std::string& path);
    /// A quick look at the file's first bytes: whether open() would take it for a database.
    [[nodiscard]] static bool looksLikeOne(const std::string& path);

    Recording(Recording&&) = default;
    Recording& operator=(Recording&&) = default;

    [[nodiscard]] const std::string& path() const;
    [[nodiscard]] const RecordingHead& head() const { return m_head; }
    [[nodiscard]] const std::vector<StreamInfo>& streams() const { return m_streams; }
    [[nodiscard]] const std::vector<TimeAnchor>& anchors() const { return m_anchors; }
    /// In order of time.
    [[nodiscard]] const std::vector<RecordingEvent>& events() const { return m_events; }
    /// Whether it ended on purpose: by a person, or by the end of a simulated scene; not by a killed program
    /// or a full disk.
    [[nodiscard]] bool isComplete() const;

    /// The first stream of a kind; empty: there is none.
    [[nodiscard]] std::optional<std::size_t> first(StreamKind kind) const;

    /// From the first to the last readable frame of a stream; empty: it has no frames.
    struct Extent {
        std::int64_t first_ns = 0;
        std::int64_t last_ns = 0;
        std::uint64_t frames = 0;
    };
    [[nodiscard]] core::Expected<std::optional<Extent>> extent(std::size_t stream) const;

    [[nodiscard]] StreamReader reader(std::size_t stream) const;

    /// Since the start of the recording, in s.
    [[nodiscard]] double time_s(std::int64_t time_ns) const;
    /// By the last anchor before, or the first one.
    [[nodiscard]] QDateTime utcOf(std::int64_t time_ns) const;

private:
    explicit Recording(std::shared_ptr<RecordingDatabase> database);
    template <typename Row>
    [[nodiscard]] core::Expected<void> forEachRow(QSqlQuery& query, const Row& row) const;
    [[nodiscard]] core::Expected<void> readHead();
    [[nodiscard]] core::Expected<void> readAnchors();
    [[nodiscard]] core::Expected<void> readStreams();
    [[nodiscard]] core::Expected<void> readColumns();
    [[nodiscard]] core::Expected<void> readEvents();
    [[nodiscard]] core::Expected<std::optional<Extent>> readableExtent(std::size_t stream) const;

    std::shared_ptr<RecordingDatabase> m_database;
    RecordingHead m_head;
    std::vector<StreamInfo> m_streams;
    std::vector<long long> m_keys;
    std::vector<TimeAnchor> m_anchors;
    std::vector<RecordingEvent> m_events;
};

} // namespace teleta::recording
