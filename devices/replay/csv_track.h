// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/csv_cursor.h"
#include "devices/replay/csv_recording.h"
#include "devices/replay/playback_track.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace teleta::replay {

/// The frames of a CSV file. A row that cannot be read ends the track with an error.
/// Thread: one.
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

} // namespace teleta::replay
