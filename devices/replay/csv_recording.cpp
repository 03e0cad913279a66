// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/frame_file.h"
#include "backend/core/failure.h"
#include "devices/replay/frame_index.h"
#include "devices/replay/playback_recording.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::replay {

namespace {

constexpr int kProbedFrames = 32;
constexpr double kPeriodOfUnknownRate_ns = 1e8;
/// A gap in a recording may be longer than the clock can count.
constexpr double kLongestTime_ns = 4e18;
constexpr double kLongestPeriod_ns = 1e18;
constexpr std::int64_t kRounding_ns = 1000;

/// Reads the frames of a recording one after the other and knows their numbers.
class CsvCursor {
public:
    /// Error: as core::FrameFile::open; refused for a pipe, which has no positions to go to.
    [[nodiscard]] static core::Expected<CsvCursor> open(const std::string& path,
                                                        const core::ArrayLayout& layout) {
        TELETA_TRY(core::FrameFile file, core::FrameFile::open(path, layout));
        if (file.bytesTotal() == 0)
            return core::failed(
                core::ErrorKind::refused,
                QCoreApplication::translate("ReplayDevice", "only a file can be played, not a pipe"), {},
                {path});
        return CsvCursor(std::move(file));
    }

    /// Reads the next frame. False at the end of the file: the last frame that was read then stays.
    [[nodiscard]] core::Expected<bool> read() {
        FramePlace place{.frame = m_next, .time_s = 0.0, .offset = m_file.offset(), .line = m_file.line()};
        const core::Expected<bool> any = m_file.next(place.time_s, m_values);
        if (any && *any) {
            m_place = place;
            if (m_next == 0)
                m_first = place;
            ++m_next;
        }
        return any;
    }

    /// The next frame to be read is this one.
    [[nodiscard]] core::Expected<void> goTo(const FramePlace& place) {
        TELETA_CHECK(m_file.seek(place.offset, place.line));
        m_next = place.frame;
        return {};
    }

    /// The frame that was read last.
    [[nodiscard]] const FramePlace& place() const { return m_place; }
    [[nodiscard]] std::span<const float> values() const { return m_values; }
    /// The first frame of the recording; after the first read().
    [[nodiscard]] const FramePlace& first() const { return m_first; }

private:
    explicit CsvCursor(core::FrameFile file)
        : m_file(std::move(file))
        , m_values(m_file.layout().taxels()) {}

    core::FrameFile m_file;
    FramePlace m_first;
    FramePlace m_place;
    std::vector<float> m_values;
    std::uint64_t m_next = 0; ///< number of the next frame
};

class CsvRecording : public PlaybackRecording {
public:
    CsvRecording(const CsvConfig& config, double recordedRate_Hz, const FramePlace& first);

    /// 0 when unknown.
    [[nodiscard]] double nominalRate_Hz() const { return m_rate_Hz.value_or(m_recordedRate_Hz); }

    [[nodiscard]] PlaybackExtent extent() const override;
    [[nodiscard]] core::Expected<PlaybackTracks> openTracks(std::function<bool()> isInterrupted) override;
    void startIndexing() override;
    void stopIndexing() override;

    // For the track.
    [[nodiscard]] const FrameIndex& index() const { return m_index; }
    [[nodiscard]] std::int64_t time_ns(const FramePlace& place) const;
    [[nodiscard]] double sourceTime_s(const FramePlace& place) const;
    /// A place from which to read on to find a time.
    [[nodiscard]] FramePlace before(std::int64_t time_ns) const;

private:
    void buildIndex(const std::stop_token& stop);

    std::string m_path;
    core::ArrayLayout m_layout;
    std::optional<double> m_rate_Hz; ///< instead of the recorded times
    double m_recordedRate_Hz;
    double m_first_s; ///< time of the first frame in the file
    FrameIndex m_index;
    std::jthread m_indexThread;
};

/// The frames of a CSV file. A row that cannot be read ends the track with an error.
class CsvTrack : public PlaybackTrack {
public:
    /// recording must outlive the track. isInterrupted: asked for each row of a search.
    CsvTrack(CsvCursor cursor, const CsvRecording& recording, std::function<bool()> isInterrupted);

    [[nodiscard]] core::Expected<void> seek(std::int64_t time_ns) override;
    [[nodiscard]] core::Expected<void> advance() override;
    [[nodiscard]] core::Expected<std::uint64_t> back(std::uint64_t frames) override;
    [[nodiscard]] bool atEnd() const override { return m_atEnd; }
    [[nodiscard]] std::int64_t time_ns() const override { return m_recording.time_ns(m_cursor.place()); }
    [[nodiscard]] double sourceTime_s() const override { return m_recording.sourceTime_s(m_cursor.place()); }
    [[nodiscard]] std::optional<std::uint64_t> frame() const override { return m_cursor.place().frame; }

protected:
    [[nodiscard]] std::span<const std::byte> bytes() const override {
        return std::as_bytes(m_cursor.values());
    }

private:
    template <typename Reached>
    [[nodiscard]] core::Expected<void> scan(const FramePlace& from, const Reached& reached);

    CsvCursor m_cursor;
    const CsvRecording& m_recording;
    std::function<bool()> m_isInterrupted;
    bool m_atEnd = true;      ///< also before the first seek
    bool m_canReadOn = false; ///< the next read gives the frame behind the cursor's
};

/// Frame rate over the first frames; 0 when they span no time.
core::Expected<double> probeRate_Hz(CsvCursor& cursor) {
    TELETA_CHECK(cursor.read());
    for (int i = 1; i < kProbedFrames; ++i) {
        // Errors further on are reported when playing gets there.
        if (const core::Expected<bool> more = cursor.read(); !more || !*more)
            break;
    }
    const double span_s = cursor.place().time_s - cursor.first().time_s;
    return span_s > 0.0 ? static_cast<double>(cursor.place().frame) / span_s : 0.0;
}

std::int64_t toNs(double time_s) {
    return std::llround(std::clamp(time_s * 1e9, -kLongestTime_ns, kLongestTime_ns));
}

CsvRecording::CsvRecording(const CsvConfig& config, double recordedRate_Hz, const FramePlace& first)
    : m_path(config.path)
    , m_layout(config.layout)
    , m_rate_Hz(config.rate_Hz)
    , m_recordedRate_Hz(recordedRate_Hz)
    , m_first_s(first.time_s) {
    m_index.add(first);
}

PlaybackExtent CsvRecording::extent() const {
    const FrameIndex::Extent known = m_index.extent();
    const FramePlace last{.frame = known.frames - 1, .time_s = known.lastTime_s};
    const double rate_Hz = nominalRate_Hz();
    return {.first_ns = 0,
            .last_ns = time_ns(last),
            .frames = known.frames,
            .period_ns = rate_Hz > 0.0 ? std::min(1e9 / rate_Hz, kLongestPeriod_ns) : kPeriodOfUnknownRate_ns,
            .complete = known.complete};
}

core::Expected<PlaybackTracks> CsvRecording::openTracks(std::function<bool()> isInterrupted) {
    TELETA_TRY(CsvCursor cursor, CsvCursor::open(m_path, m_layout));
    PlaybackTracks tracks;
    tracks.frames = std::make_unique<CsvTrack>(std::move(cursor), *this, std::move(isInterrupted));
    return tracks;
}

std::int64_t CsvRecording::time_ns(const FramePlace& place) const {
    return toNs(m_rate_Hz ? static_cast<double>(place.frame) / *m_rate_Hz : place.time_s - m_first_s);
}

double CsvRecording::sourceTime_s(const FramePlace& place) const {
    return m_rate_Hz ? static_cast<double>(place.frame) / *m_rate_Hz : place.time_s;
}

FramePlace CsvRecording::before(std::int64_t time_ns) const {
    // Rounding must not put a place at the time itself: an earlier frame may have the same time.
    const double time_s = static_cast<double>(time_ns - kRounding_ns) * 1e-9;
    if (!m_rate_Hz)
        return m_index.beforeTime(m_first_s + time_s);
    const double frame = std::min(std::floor(time_s * *m_rate_Hz), 0x1p62);
    return m_index.atFrame(frame > 1.0 ? static_cast<std::uint64_t>(frame) - 1 : 0);
}

void CsvRecording::startIndexing() {
    if (!m_indexThread.joinable())
        m_indexThread = std::jthread([this](const std::stop_token& stop) { buildIndex(stop); });
}

void CsvRecording::stopIndexing() {
    if (m_indexThread.joinable()) {
        m_indexThread.request_stop();
        m_indexThread.join();
    }
}

void CsvRecording::buildIndex(const std::stop_token& stop) {
    core::Expected<CsvCursor> cursor = CsvCursor::open(m_path, m_layout);
    if (cursor && cursor->goTo(m_index.atFrame(m_index.extent().frames))) {
        for (;;) {
            if (stop.stop_requested())
                return;
            // What cannot be read ends the recording; the worker reports it when it gets there.
            const core::Expected<bool> any = cursor->read();
            if (!any || !*any)
                break;
            if (cursor->place().frame >= m_index.extent().frames)
                m_index.add(cursor->place());
        }
    }
    m_index.complete();
}

CsvTrack::CsvTrack(CsvCursor cursor, const CsvRecording& recording, std::function<bool()> isInterrupted)
    : m_cursor(std::move(cursor))
    , m_recording(recording)
    , m_isInterrupted(std::move(isInterrupted)) {
}

core::Expected<void> CsvTrack::seek(std::int64_t time_ns) {
    return scan(m_recording.before(time_ns),
                [&](const FramePlace& place) { return m_recording.time_ns(place) >= time_ns; });
}

core::Expected<void> CsvTrack::advance() {
    const core::Expected<bool> any = m_cursor.read();
    m_atEnd = !any || !*any;
    m_canReadOn = any.has_value();
    TELETA_CHECK(any);
    return {};
}

core::Expected<std::uint64_t> CsvTrack::back(std::uint64_t frames) {
    const std::uint64_t here = m_cursor.place().frame + (m_atEnd ? 1 : 0);
    const std::uint64_t target = here - std::min(frames, here);
    if (target != here)
        TELETA_CHECK(scan(m_recording.index().atFrame(target),
                          [target](const FramePlace& place) { return place.frame >= target; }));
    return here - target;
}

/// Reads on until a frame is reached, or to the end; from a known place if that is nearer.
template <typename Reached>
core::Expected<void> CsvTrack::scan(const FramePlace& from, const Reached& reached) {
    const FramePlace& here = m_cursor.place();
    if (!m_canReadOn || here.frame < from.frame || reached(here))
        TELETA_CHECK(m_cursor.goTo(from));
    do {
        if (m_isInterrupted())
            return core::Unexpected(core::Error{core::ErrorKind::cancelled, {}, {}, {}});
        TELETA_CHECK(advance());
    } while (!m_atEnd && !reached(m_cursor.place()));
    return {};
}

} // namespace

core::Expected<std::unique_ptr<PlaybackRecording>> openCsvRecording(CsvConfig& config) {
    TELETA_TRY(CsvCursor cursor, CsvCursor::open(config.path, config.layout));
    TELETA_TRY(const double rate_Hz, probeRate_Hz(cursor));
    auto recording = std::make_unique<CsvRecording>(config, rate_Hz, cursor.first());
    config.array = {.name = std::filesystem::path(config.path).filename().string(),
                    .layout = config.layout,
                    .unit = config.unit,
                    .nominalRate_Hz = recording->nominalRate_Hz(),
                    .simulated = false,
                    .recorded = true};
    config.startsQuietly = true;
    return recording;
}

} // namespace teleta::replay
