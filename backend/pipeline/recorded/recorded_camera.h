// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/pipeline/recorded/recorded_pictures.h"
#include "backend/recording/recording.h"
#include "backend/recording/recording_types.h"
#include "backend/vision/camera/cylinder_projection.h"
#include "backend/vision/contacts/camera_tracker.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::pipeline {

/// How a camera in the soft tube is recorded, and what is needed to find contacts in its pictures again.
/// Thread: any (pure).

inline constexpr std::size_t kContactValues = 10;

/// Pictures of a camera, with its calibration, and the thresholds of a bump. name: of the stream; reference:
/// of that of its references.
[[nodiscard]] recording::StreamInfo cameraStream(const std::string& name,
                                                 const core::CameraDescription& description,
                                                 const vision::CylinderCamera& camera,
                                                 const vision::BumpDetector::Settings& bump,
                                                 const std::string& reference);
/// Pictures of the tube with nothing touching it, with which the others are compared from then on.
[[nodiscard]] recording::StreamInfo referenceStream(const std::string& name,
                                                    const core::CameraDescription& description);
/// Contacts that were found, one frame a contact.
[[nodiscard]] recording::StreamInfo contactStream(const std::string& name,
                                                  const core::CameraDescription& description);

/// A frame of a stream of contacts; NaN where nothing is known.
[[nodiscard]] std::array<double, kContactValues> contactValues(const vision::FollowedContact& followed);

/// A camera of a recording.
struct RecordedCamera : RecordedPictures {
    vision::CylinderCamera camera;
    vision::BumpDetector::Settings bump;
};

/// Every camera of a recording, in its order; one without a picture and one that is not described are left
/// out. why: gets the error of the first one that is not described, unless it has one. Error: ioFailed.
[[nodiscard]] core::Expected<std::vector<RecordedCamera>>
recordedCameras(const recording::Recording& recording, std::optional<core::Error>& why);

/// The reference with which a recorded camera begins: the first one of its stream that is whole; empty when
/// it has none of its own. Error: ioFailed.
[[nodiscard]] core::Expected<core::GreyImage>
firstReference(const recording::Recording& recording, const std::optional<std::size_t>& referenceStream);

} // namespace teleta::pipeline
