// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/replay/csv_cursor.h"
#include "devices/replay/frame_index.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/playback_recording.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace teleta::replay {

/// Recorded tactile frames in a CSV file, which a thread of its own indexes while they are played. Times
/// count from the first frame. Thread: startIndexing() and stopIndexing() from the controlling one; otherwise
/// as PlaybackRecording.
class CsvRecording : public PlaybackRecording {
public:
    /// Reads the header and the first frames, which tell the frame rate.
    /// Error: the file cannot be opened or read, has no frames, or does not fit the layout.
    [[nodiscard]] static core::Expected<std::unique_ptr<CsvRecording>> open(const CsvConfig& config);

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
    CsvRecording(const CsvConfig& config, double recordedRate_Hz, const FramePlace& first);
    void buildIndex(const std::stop_token& stop);

    std::string m_path;
    core::ArrayLayout m_layout;
    std::optional<double> m_rate_Hz; ///< instead of the recorded times
    double m_recordedRate_Hz;
    double m_first_s; ///< time of the first frame in the file
    FrameIndex m_index;
    std::jthread m_indexThread;
};

} // namespace teleta::replay
