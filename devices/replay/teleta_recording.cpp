// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/teleta_recording.h"

#include "backend/core/failure.h"
#include "devices/replay/recorded_track.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::replay {

core::Expected<std::unique_ptr<TeletaRecording>> TeletaRecording::open(const RecordedConfig& config) {
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
    std::vector<Mark> marks;
    const std::int64_t start_ns = recording.head().start_ns;
    for (const recording::RecordingEvent& event : recording.events())
        if (event.kind == recording::kMark)
            marks.push_back(
                {event.time_ns, static_cast<double>(event.time_ns - start_ns) * 1e-9, event.text});
    return std::unique_ptr<TeletaRecording>(new TeletaRecording(config, extent, std::move(marks)));
}

TeletaRecording::TeletaRecording(const RecordedConfig& config, PlaybackExtent extent, std::vector<Mark> marks)
    : m_config(config)
    , m_extent(extent)
    , m_marks(std::move(marks)) {
}

core::Expected<PlaybackTracks> TeletaRecording::openTracks(std::function<bool()> /*isInterrupted*/) {
    TELETA_TRY(recording::Recording recording, recording::Recording::open(m_config.path));
    PlaybackTracks tracks;
    tracks.recording = std::make_unique<recording::Recording>(std::move(recording));
    tracks.frames = std::make_unique<RecordedTrack>(*tracks.recording, m_config.stream);
    if (m_config.jointStream)
        tracks.joints = std::make_unique<RecordedTrack>(*tracks.recording, *m_config.jointStream);
    tracks.references = std::make_unique<RecordedReferences>(*tracks.recording, m_config.referenceStream);
    return tracks;
}

} // namespace teleta::replay
