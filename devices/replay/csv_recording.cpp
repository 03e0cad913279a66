// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/csv_recording.h"

#include "devices/replay/csv_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::replay {

namespace {

constexpr int kProbedFrames = 32;
constexpr double kPeriodOfUnknownRate_ns = 1e8;
/// A gap in a recording may be longer than the clock can count.
constexpr double kLongestTime_ns = 4e18;
constexpr double kLongestPeriod_ns = 1e18;
constexpr std::int64_t kRounding_ns = 1000;

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

} // namespace

core::Expected<std::unique_ptr<CsvRecording>> CsvRecording::open(const CsvConfig& config) {
    TELETA_TRY(CsvCursor cursor, CsvCursor::open(config.path, config.layout));
    TELETA_TRY(const double rate_Hz, probeRate_Hz(cursor));
    return std::unique_ptr<CsvRecording>(new CsvRecording(config, rate_Hz, cursor.first()));
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

} // namespace teleta::replay
