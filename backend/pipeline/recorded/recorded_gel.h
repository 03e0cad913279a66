// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/pipeline/recorded/gel_loads.h"
#include "backend/pipeline/recorded/recorded_pictures.h"
#include "backend/recording/recording.h"
#include "backend/recording/recording_types.h"
#include "backend/vision/gel/gel_contacts.h"
#include "backend/vision/gel/marker_gel_file.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::pipeline {

/// How a flat gel with markers is recorded, and what is needed to follow its markers again. Thread: any
/// (pure).

inline constexpr std::size_t kGelContactValues = 9;

/// Pictures of a gel, cropped and flipped, with its file. name: of the stream; reference: of that of its
/// references. loads: how the loads of its contacts follow from them; null: not known.
[[nodiscard]] recording::StreamInfo gelStream(const std::string& name,
                                              const core::CameraDescription& description,
                                              const vision::MarkerGelFile& file, const std::string& reference,
                                              const equilibration::LoadCalibration* loads = nullptr);
/// Pictures of the gel at rest, as stackedReference(), from which its markers' places are found until the
/// next one comes.
[[nodiscard]] recording::StreamInfo gelReferenceStream(const std::string& name,
                                                       const core::CameraDescription& description);
/// Contacts that were found, one frame a contact. loads: those that follow by it are further columns, as
/// loadColumns(); null: none.
[[nodiscard]] recording::StreamInfo gelContactStream(const std::string& name,
                                                     const core::CameraDescription& description,
                                                     const equilibration::LoadCalibration* loads = nullptr);
/// A frame of a stream of contacts without loads; NaN where nothing is known.
[[nodiscard]] std::array<double, kGelContactValues> gelContactValues(const vision::GelContactState& contact);

/// The pictures of a gel at rest, one below the other, as one picture; empty: they are none, or differ in
/// size.
[[nodiscard]] core::GreyImage stackedReference(std::span<const core::GreyImage> pictures);
/// The pictures in it again; empty: its height is no multiple of theirs, or its width another one.
[[nodiscard]] std::vector<core::GreyImage> unstackedReference(const core::GreyImage& stack, int width_px,
                                                              int height_px);

/// A gel and the camera that looks at it.
struct DescribedGel {
    core::CameraDescription description;
    vision::MarkerGelFile file;
    std::optional<GelLoads> loads = {};
};

/// The inverse of gelStream(); the pictures come from somewhere else than a recording. file: named in errors.
/// Error: badInput.
[[nodiscard]] core::Expected<DescribedGel> gelOf(const recording::StreamInfo& stream,
                                                 const std::string& file);

/// A gel of a recording.
struct RecordedGel : RecordedPictures {
    vision::MarkerGelFile file;
    std::optional<GelLoads> loads = {};
};

/// Every gel of a recording, in its order; one without a picture and one that is not described are left out.
/// why: gets the error of the first one that is not described, unless it has one. Error: ioFailed.
[[nodiscard]] core::Expected<std::vector<RecordedGel>> recordedGels(const recording::Recording& recording,
                                                                    std::optional<core::Error>& why);

} // namespace teleta::pipeline
