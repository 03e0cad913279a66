// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/playback_recording.h"

#include <memory>
#include <vector>

namespace teleta::replay {

/// An array and the joints of the arm that wears it, or a camera, in a .teleta recording. Times are the
/// recording's own. Thread: as PlaybackRecording.
class TeletaRecording : public PlaybackRecording {
public:
    /// Error: as recording::Recording::open; refused when the stream has no frames.
    [[nodiscard]] static core::Expected<std::unique_ptr<TeletaRecording>> open(const RecordedConfig& config);

    [[nodiscard]] PlaybackExtent extent() const override { return m_extent; }
    [[nodiscard]] core::Expected<PlaybackTracks> openTracks(std::function<bool()> isInterrupted) override;
    [[nodiscard]] std::vector<Mark> marks() const override { return m_marks; }

private:
    TeletaRecording(const RecordedConfig& config, PlaybackExtent extent, std::vector<Mark> marks);

    RecordedConfig m_config;
    PlaybackExtent m_extent;
    std::vector<Mark> m_marks;
};

} // namespace teleta::replay
