// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/core/interface.h"
#include "backend/recording/recording.h"
#include "devices/replay/playback_config.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::replay {

/// One stream of a recording, read frame by frame. It stands at a frame or, at its end, behind the last one.
/// Thread: one.
class PlaybackTrack : public core::Interface {
public:
    /// Goes to the first frame at or after a time, or to the end if there is none.
    [[nodiscard]] virtual core::Expected<void> seek(std::int64_t time_ns) = 0;
    /// Goes to the next frame.
    [[nodiscard]] virtual core::Expected<void> advance() = 0;
    /// Goes back by this many frames, at most to the first one. Returns by how many.
    [[nodiscard]] virtual core::Expected<std::uint64_t> back(std::uint64_t frames) = 0;
    [[nodiscard]] virtual bool atEnd() const = 0;

    // Of the frame at which it stands.
    [[nodiscard]] virtual std::int64_t time_ns() const = 0;
    [[nodiscard]] virtual double sourceTime_s() const = 0;
    /// Number in the recording; empty when the format does not number its frames.
    [[nodiscard]] virtual std::optional<std::uint64_t> frame() const { return std::nullopt; }
    /// The stream jumped before this frame when it was recorded, or frames before it are damaged.
    [[nodiscard]] virtual bool jumps() const { return false; }
    /// Values of the stream's type. Valid until the track moves.
    template <typename Number>
    [[nodiscard]] std::span<const Number> values() const {
        const std::span<const std::byte> all = bytes();
        return {reinterpret_cast<const Number*>(all.data()), all.size() / sizeof(Number)};
    }
    /// The picture, if it is a stream of pictures.
    [[nodiscard]] virtual core::GreyImage image() const { return {}; }

    /// Damaged blocks that were skipped since the track was opened.
    [[nodiscard]] virtual std::uint64_t damagedBlocks() const { return 0; }

protected:
    [[nodiscard]] virtual std::span<const std::byte> bytes() const = 0;
};

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
    std::unique_ptr<PlaybackTrack> joints;       ///< of the arm that wears the array; null: none
    std::unique_ptr<PlaybackTrack> wrench;       ///< forces and torques at the arm's wrist; null: none
    std::unique_ptr<PlaybackTrack> temperatures; ///< of the array's chips; null: none
    /// The reference of a camera's picture of this time if it differs from that of the last call (initially:
    /// from the first one); otherwise empty.
    std::function<core::GreyImage(std::int64_t time_ns)> referenceAt = [](std::int64_t) {
        return core::GreyImage{};
    };
};

/// A recording that a RecordedPlayer plays, in one of the formats.
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

/// An array and the joints of the arm that wears it, or a camera, in a .teleta recording. Times are the
/// recording's own. Damaged blocks are skipped and counted.
/// Error: as recording::Recording::open; refused when the stream has no frames.
[[nodiscard]] core::Expected<std::unique_ptr<PlaybackRecording>>
openTeletaRecording(const RecordedConfig& config);

/// Recorded tactile frames in a CSV file; a thread of its own indexes the file while they are played. Times
/// count from the first frame. Reads the header and the first frames to find the frame rate (0: unknown), and
/// describes the array in the configuration.
/// Error: the file cannot be opened or read, has no frames, does not fit the layout, or is a pipe.
[[nodiscard]] core::Expected<std::unique_ptr<PlaybackRecording>> openCsvRecording(CsvConfig& config);

} // namespace teleta::replay
