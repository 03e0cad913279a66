// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/device/device.h"
#include "backend/core/threads/pacing_clock.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace teleta::replay {

/// How a recording is played, whatever its format.
struct PlaybackConfig {
    /// A part of a recording. All sources that are played together have the same one.
    struct Span {
        std::int64_t first_ns = 0;
        std::int64_t last_ns = 0;
    };

    core::SourceDescription array;
    core::ArmDescription arm;                      ///< that wears the array
    bool hasWrench = false;                        ///< of that arm; RecordedPlayer::open() finds out
    std::size_t chips = 0;                         ///< of the array that tell how warm they are
    bool jointsAlone = false;                      ///< the stream is the arm's; there is no array
    std::optional<core::CameraDescription> camera; ///< set: the stream is a camera's, not an array's
    std::optional<Span> span;                      ///< empty: from the first frame to the last

    double speed = 1.0; ///< 0.01 .. 100, or infinity: as fast as the consumer takes the frames
    bool loop = false;
    bool autoplay = true;       ///< false: shows the first frame and waits
    bool startsQuietly = false; ///< the very first frame is not marked as a discontinuity

    std::size_t queueBlocks = 256;
    std::size_t queueJoints = 16'384; ///< of joint samples, of forces, and of temperatures
    std::size_t queuePictures = 8;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

/// Streams of a .teleta recording.
struct RecordedConfig : PlaybackConfig {
    std::string path;
    std::size_t stream = 0;                       ///< number in the recording: an array, a camera, or an arm
    std::optional<std::size_t> jointStream;       ///< of the arm that wears the array
    std::optional<std::size_t> wrenchStream;      ///< of the sensor at that arm's wrist
    std::optional<std::size_t> temperatureStream; ///< of the array; each frame of it has `chips` numbers
    std::optional<std::size_t> referenceStream;   ///< of the camera; playback starts with its first picture
};

/// A CSV file of tactile frames.
struct CsvConfig : PlaybackConfig {
    std::string path;
    core::ArrayLayout layout;
    std::string unit = "N"; ///< of the recorded values; the file does not tell

    /// Frames count as recorded at this rate, whatever times the file has; > 0.
    std::optional<double> rate_Hz;
};

} // namespace teleta::replay
