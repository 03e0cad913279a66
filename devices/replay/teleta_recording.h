// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/playback_recording.h"

#include <memory>

namespace teleta::replay {

/// An array and the joints of the arm that wears it, or a camera, in a .teleta recording. Times are the
/// recording's own. Damaged blocks are skipped and counted.
/// Error: as recording::Recording::open; refused when the stream has no frames.
[[nodiscard]] core::Expected<std::unique_ptr<PlaybackRecording>>
openTeletaRecording(const RecordedConfig& config);

} // namespace teleta::replay
