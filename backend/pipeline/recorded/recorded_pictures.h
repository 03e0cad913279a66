// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/json_document.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/recording/recording.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::pipeline {

/// What all recorded streams of pictures have, whatever they show.
struct RecordedPictures {
    std::size_t stream = 0; ///< number in the recording
    core::CameraDescription description;
    std::optional<std::size_t> referenceStream; ///< empty: the first pictures are the reference
};

/// Reads it from the details of a stream. What is wrong with them is in the reader.
[[nodiscard]] RecordedPictures readPictures(const recording::Recording& recording, std::size_t stream,
                                            core::JsonReader& details);

/// Every stream of pictures that read(recording, stream) knows, in the order of the recording; one without a
/// picture and one that is not described are left out. read: gives an Expected<std::optional<Found>>; empty:
/// the stream is something else. why: gets the error of the first one that is not described, unless it has
/// one. Error: ioFailed.
template <typename Found, typename Read>
[[nodiscard]] core::Expected<std::vector<Found>> allPictures(const recording::Recording& recording,
                                                             std::optional<core::Error>& why, Read read) {
    std::vector<Found> all;
    for (std::size_t i = 0; i < recording.streams().size(); ++i) {
        if (recording.streams()[i].type != recording::ValueType::grey8)
            continue;
        auto found = read(recording, i);
        if (!found) {
            why = why.value_or(found.error());
            continue;
        }
        if (!*found)
            continue;
        TELETA_TRY(const auto extent, recording.extent(i));
        if (extent)
            all.push_back(std::move(**found));
    }
    return all;
}

} // namespace teleta::pipeline
