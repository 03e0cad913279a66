// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/playback_recording.h"

#include <memory>

namespace teleta::replay {

/// Recorded tactile frames in a CSV file, which a thread of its own indexes while they are played. Times
/// count from the first frame. Reads the header and the first frames, which tell the frame rate (0: unknown),
/// and describes the array in the configuration.
/// Error: the file cannot be opened or read, has no frames, does not fit the layout, or is a pipe.
[[nodiscard]] core::Expected<std::unique_ptr<PlaybackRecording>> openCsvRecording(CsvConfig& config);

} // namespace teleta::replay
