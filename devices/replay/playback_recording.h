// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/interface.h"
#include "backend/recording/recording.h"
#include "devices/replay/playback_track.h"
#include "devices/replay/recorded_references.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace teleta::replay {

/// How long a recording is.
struct PlaybackExtent {
    std::int64_t first_ns = 0;
    std::int64_t last_ns = 0;
    std::uint64_t frames = 0;
    double period_ns = 0.0; ///< mean distance of the frames; 0: unknown
    bool complete = true;   ///< false: the file is still being indexed and may be longer
};

/// The open streams of a recording that are played together.
struct PlaybackTracks {
    std::unique_ptr<recording::Recording> recording; ///< in which the tracks read, for a .teleta file
    std::unique_ptr<PlaybackTrack> frames;
    std::unique_ptr<PlaybackTrack> joints;          ///< of the arm that wears the array; null: none
    std::unique_ptr<RecordedReferences> references; ///< of the camera; null: none
};

/// A recording that a PlaybackWorker plays, in one of the formats.
class PlaybackRecording : public core::Interface {
public:
    struct Mark {
        std::int64_t time_ns = 0;
        double sourceTime_s = 0.0;
        std::string text;
    };

    /// What is known so far. Thread: any.
    [[nodiscard]] virtual PlaybackExtent extent() const = 0;
    /// Opens the tracks. isInterrupted: asked during long searches, which then fail as cancelled.
    /// Thread: the one that will read the tracks.
    [[nodiscard]] virtual core::Expected<PlaybackTracks> openTracks(std::function<bool()> isInterrupted) = 0;
    /// In order of time. Thread: any.
    [[nodiscard]] virtual std::vector<Mark> marks() const { return {}; }
    /// Around playing: starts and stops indexing the file. Thread: the controlling one.
    virtual void startIndexing() {}
    virtual void stopIndexing() {}
};

} // namespace teleta::replay
