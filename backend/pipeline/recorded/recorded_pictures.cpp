// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_pictures.h"

#include "backend/recording/recording_types.h"

#include <algorithm>
#include <string>

namespace teleta::pipeline {

RecordedPictures readPictures(const recording::Recording& recording, std::size_t stream,
                              core::JsonReader& details) {
    const std::vector<recording::StreamInfo>& streams = recording.streams();
    const std::string reference = details.text(details.root(), "reference_stream", {});
    RecordedPictures pictures{
        .stream = stream,
        .description = {.name = streams[stream].source,
                        .nominalRate_Hz = streams[stream].nominalRate_Hz,
                        .simulated = details.boolean(details.root(), "simulated", false),
                        .recorded = true},
        .referenceStream = {}};
    const auto named = std::ranges::find(streams, reference, &recording::StreamInfo::name);
    if (named != streams.end() && named->type == recording::ValueType::grey8)
        pictures.referenceStream = static_cast<std::size_t>(named - streams.begin());
    return pictures;
}

} // namespace teleta::pipeline
