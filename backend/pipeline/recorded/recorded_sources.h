// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pipeline/recorded/recorded_camera.h"
#include "backend/pipeline/recorded/recorded_gel.h"
#include "backend/pipeline/recorded/recorded_scene_camera.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/recording.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace teleta::pipeline {

/// An array of a recording, and the arm that wears it.
struct RecordedSource {
    std::size_t arrayStream = 0; ///< number in the recording
    RecordedArray array;
    std::optional<std::size_t> jointStream;       ///< empty: the array was on its own
    std::optional<std::size_t> wrenchStream;      ///< of the sensor at that arm's wrist
    std::optional<std::size_t> temperatureStream; ///< of the array's chips
    std::size_t chips = 0;                        ///< temperatures of a frame of it
    core::ArmDescription arm;
    std::shared_ptr<const arm_model::SerialChain> chain; ///< as RecordedArm::chain
};

/// An arm of a recording that wears no array.
struct RecordedJoints {
    std::size_t stream = 0;                  ///< number in the recording
    std::optional<std::size_t> wrenchStream; ///< of the sensor at its wrist
    core::ArmDescription arm;
    std::shared_ptr<const arm_model::SerialChain> chain; ///< as RecordedArm::chain
};

/// What of a recording can be used as sources again.
struct RecordedSources {
    std::vector<RecordedSource> arrays;
    std::vector<RecordedJoints> arms;
    std::vector<RecordedCamera> cameras;
    std::vector<RecordedGel> gels;
    std::vector<RecordedSceneCamera> sceneCameras;
    std::int64_t first_ns = 0; ///< of the first frame of all of them
    std::int64_t last_ns = 0;  ///< of the last one
};

/// The arrays, arms, cameras of all kinds and gels of a recording that have frames, in its order; what is not
/// described is left out. Error: badInput, nothing is left and a stream's details do not say what it is;
/// refused: there is none.
[[nodiscard]] core::Expected<RecordedSources> recordedSources(const recording::Recording& recording);

} // namespace teleta::pipeline
