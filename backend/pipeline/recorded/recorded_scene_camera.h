// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/pipeline/recorded/recorded_pictures.h"
#include "backend/recording/recording.h"
#include "backend/recording/recording_types.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::pipeline {

/// How a camera that is only looked at is recorded. Thread: any (pure).

/// Colour pictures, whose size may vary. name: of the stream.
[[nodiscard]] recording::StreamInfo sceneCameraStream(const std::string& name,
                                                      const core::CameraDescription& description);

/// The inverse. file: named in errors. Error: badInput, the stream is of something else, or does not say
/// what it is of.
[[nodiscard]] core::Expected<core::CameraDescription> sceneCameraOf(const recording::StreamInfo& stream,
                                                                    const std::string& file);

/// A scene camera of a recording.
struct RecordedSceneCamera : RecordedPictures {};

/// Every scene camera of a recording, as recordedGels().
[[nodiscard]] core::Expected<std::vector<RecordedSceneCamera>>
recordedSceneCameras(const recording::Recording& recording, std::optional<core::Error>& why);

} // namespace teleta::pipeline
