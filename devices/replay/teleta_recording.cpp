// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/failure.h"
#include "backend/recording/recording.h"
#include "devices/replay/playback_recording.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace teleta::replay {

namespace {

/// A stream of a .teleta recording. Damaged blocks are skipped and counted.
class RecordedTrack : public PlaybackTrack {
public:
    /// recording must outlive the track.
    RecordedTrack(const recording::Recording& recording, std::size_t stream);

    [[nodiscard]] core::Expected<void> seek(std::int64_t time_ns) override;
    [[nodiscard]] core::Expected<void> advance() override;
    [[nodiscard]] core::Expected<std::uint64_t> back(std::uint64_t frames) override;

    [[nodiscard]] bool atEnd() const override { return m_atEnd; }
    [[nodiscard]] std::int64_t time_ns() const override { return m_block.time_ns[m_index]; }
    [[nodiscard]] double sourceTime_s() const override {
        return static_cast<double>(time_ns() - m_start_ns) / 1e9;
    }
    [[nodiscard]] core::GreyImage image() const override { return m_block.image; }
    [[nodiscard]] bool jumps() const override { return (m_block.discontinuity || m_skipped) && m_index == 0; }
    [[nodiscard]] std::uint64_t damagedBlocks() const override { return m_damaged; }

protected:
    [[nodiscard]] std::span<const std::byte> bytes() const override;

private:
    [[nodiscard]] core::Expected<void> nextBlock();

    recording::StreamReader m_reader;
    std::int64_t m_start_ns; ///< of the recording
    core::TappedFrames m_block;
    std::size_t m_index = 0; ///< behind the last one at the end
    bool m_atEnd = true;     ///< also before the first seek, and after one that failed
    bool m_skipped = false;  ///< damage right before this block
    std::uint64_t m_damaged = 0;
};

RecordedTrack::RecordedTrack(const recording::Recording& recording, std::size_t stream)
    : m_reader(recording.reader(stream))
    , m_start_ns(recording.head().start_ns) {
}

std::span<const std::byte> RecordedTrack::bytes() const {
    const std::size_t size = m_block.values.size() / m_block.frames();
    return std::span(m_block.values).subspan(m_index * size, size);
}

core::Expected<void> RecordedTrack::seek(std::int64_t time_ns) {
    core::Expected<void> done = m_reader.seek(time_ns);
    m_block = {};
    m_index = 0;
    m_atEnd = true; // until there is a block
    if (done)
        done = nextBlock();
    while (done && !m_atEnd && this->time_ns() < time_ns)
        done = advance();
    return done;
}

core::Expected<void> RecordedTrack::advance() {
    if (++m_index < m_block.frames())
        return {};
    return nextBlock();
}

core::Expected<std::uint64_t> RecordedTrack::back(std::uint64_t frames) {
    std::uint64_t left = frames;
    while (left > m_index) {
        const std::uint64_t here = m_index;
        TELETA_TRY(const bool any, m_reader.previous(m_block));
        if (!any)
            break;
        left -= here;
        m_index = m_block.frames();
        m_skipped = false;
    }
    const std::uint64_t last = std::min<std::uint64_t>(left, m_index);
    m_index -= last;
    m_atEnd = m_index == m_block.frames();
    return frames - left + last;
}

core::Expected<void> RecordedTrack::nextBlock() {
    m_skipped = false;
    for (;;) {
        const core::Expected<bool> any = m_reader.next(m_block);
        const bool isDamage = !any && m_reader.canGoOn() && any.error().kind == core::ErrorKind::badInput;
        if (isDamage) {
            ++m_damaged;
            m_skipped = true;
            continue;
        }
        m_atEnd = !any || !*any;
        m_index = m_atEnd ? m_block.frames() : 0;
        TELETA_CHECK(any);
        return {};
    }
}

/// The reference pictures of a recorded camera, which may have been renewed during the recording. Keeps only
/// their times; damaged ones are skipped.
class RecordedReferences {
public:
    /// recording must outlive it.
    RecordedReferences(const recording::Recording& recording, std::size_t stream);

    /// As PlaybackTracks::referenceAt.
    [[nodiscard]] core::GreyImage changeAt(std::int64_t time_ns);

private:
    RecordedTrack m_track;
    std::vector<std::int64_t> m_times_ns; ///< rising
    std::size_t m_inUse = 0;
};

RecordedReferences::RecordedReferences(const recording::Recording& recording, std::size_t stream)
    : m_track(recording, stream) {
    core::Expected<void> read = m_track.seek(std::numeric_limits<std::int64_t>::min());
    while (read && !m_track.atEnd()) {
        m_times_ns.push_back(m_track.time_ns());
        read = m_track.advance();
    }
}

core::GreyImage RecordedReferences::changeAt(std::int64_t time_ns) {
    if (m_times_ns.size() < 2)
        return {};
    const auto after = std::ranges::upper_bound(m_times_ns, time_ns);
    const std::size_t index =
        after == m_times_ns.begin() ? 0 : static_cast<std::size_t>(after - m_times_ns.begin()) - 1;
    if (index == m_inUse || !m_track.seek(m_times_ns[index]) || m_track.atEnd())
        return {};
    m_inUse = index;
    return m_track.image();
}

class TeletaRecording : public PlaybackRecording {
public:
    TeletaRecording(const RecordedConfig& config, PlaybackExtent extent, std::vector<Mark> marks)
        : m_config(config)
        , m_extent(extent)
        , m_marks(std::move(marks)) {}

    [[nodiscard]] PlaybackExtent extent() const override { return m_extent; }
    [[nodiscard]] std::vector<Mark> marks() const override { return m_marks; }

    [[nodiscard]] core::Expected<PlaybackTracks>
    openTracks(std::function<bool()> /*isInterrupted*/) override {
        TELETA_TRY(recording::Recording recording, recording::Recording::open(m_config.path));
        PlaybackTracks tracks;
        tracks.recording = std::make_unique<recording::Recording>(std::move(recording));
        tracks.frames = std::make_unique<RecordedTrack>(*tracks.recording, m_config.stream);
        if (m_config.jointStream)
            tracks.joints = std::make_unique<RecordedTrack>(*tracks.recording, *m_config.jointStream);
        if (m_config.wrenchStream)
            tracks.wrench = std::make_unique<RecordedTrack>(*tracks.recording, *m_config.wrenchStream);
        if (m_config.temperatureStream)
            tracks.temperatures =
                std::make_unique<RecordedTrack>(*tracks.recording, *m_config.temperatureStream);
        if (m_config.referenceStream)
            tracks.referenceAt = [references = std::make_shared<RecordedReferences>(
                                      *tracks.recording, *m_config.referenceStream)](std::int64_t time_ns) {
                return references->changeAt(time_ns);
            };
        return tracks;
    }

private:
    RecordedConfig m_config;
    PlaybackExtent m_extent;
    std::vector<Mark> m_marks;
};

} // namespace

core::Expected<std::unique_ptr<PlaybackRecording>> openTeletaRecording(const RecordedConfig& config) {
    TELETA_TRY(const recording::Recording recording, recording::Recording::open(config.path));
    TELETA_TRY(const auto found, recording.extent(config.stream));
    if (!found)
        return core::failed(core::ErrorKind::refused,
                            QCoreApplication::translate("ReplayDevice", "the recording has no frames"), {},
                            {config.path});
    PlaybackExtent extent{.first_ns = found->first_ns, .last_ns = found->last_ns, .frames = found->frames};
    if (extent.frames > 1)
        extent.period_ns =
            static_cast<double>(extent.last_ns - extent.first_ns) / static_cast<double>(extent.frames - 1);
    std::vector<PlaybackRecording::Mark> marks;
    const std::int64_t start_ns = recording.head().start_ns;
    for (const recording::RecordingEvent& event : recording.events())
        if (event.kind == recording::kMark)
            marks.push_back(
                {event.time_ns, static_cast<double>(event.time_ns - start_ns) * 1e-9, event.text});
    return std::make_unique<TeletaRecording>(config, extent, std::move(marks));
}

} // namespace teleta::replay
