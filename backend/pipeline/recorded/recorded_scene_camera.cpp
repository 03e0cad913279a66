// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_scene_camera.h"

#include "backend/core/data/json_document.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/stream_columns.h"

#include <QCoreApplication>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <utility>

namespace teleta::pipeline {

namespace {

struct SceneCameraText {
    Q_DECLARE_TR_FUNCTIONS(RecordedStreams)
};

/// Empty: the stream shows something else.
core::Expected<std::optional<RecordedSceneCamera>> recordedSceneCamera(const recording::Recording& recording,
                                                                       std::size_t stream) {
    const recording::StreamInfo& info = recording.streams()[stream];
    if (!recording::isColour(info))
        return std::optional<RecordedSceneCamera>();
    const auto document = core::JsonDocument::parse(info.details, recording.path());
    if (!document)
        return notDescribed(info, recording.path(), document.error());
    core::JsonReader reader(*document);
    RecordedPictures pictures = readPictures(recording, stream, reader);
    if (reader.error())
        return notDescribed(info, recording.path(), *reader.error());
    return RecordedSceneCamera{std::move(pictures)};
}

} // namespace

recording::StreamInfo sceneCameraStream(const std::string& name, const core::CameraDescription& description) {
    nlohmann::ordered_json details{{"simulated", description.simulated}};
    // Of a video that was recorded again, or that a site plays.
    if (description.recorded)
        details["recorded"] = true;
    return {.name = name,
            .kind = recording::StreamKind::camera,
            .type = recording::ValueType::grey8,
            .source = description.name,
            .shape = {0, 0, 3},
            .nominalRate_Hz = description.nominalRate_Hz,
            .details = details.dump()};
}

core::Expected<core::CameraDescription> sceneCameraOf(const recording::StreamInfo& stream,
                                                      const std::string& file) {
    if (!recording::isColour(stream))
        return notDescribed(stream, file, SceneCameraText::tr("it is not a picture in colour"));
    const auto document = core::JsonDocument::parse(stream.details, file);
    if (!document)
        return notDescribed(stream, file, document.error());
    core::JsonReader reader(*document);
    core::CameraDescription description{.name = stream.source,
                                        .nominalRate_Hz = stream.nominalRate_Hz,
                                        .simulated = reader.boolean(reader.root(), "simulated", false),
                                        .recorded = reader.boolean(reader.root(), "recorded", false)};
    if (reader.error())
        return notDescribed(stream, file, *reader.error());
    return description;
}

core::Expected<std::vector<RecordedSceneCamera>> recordedSceneCameras(const recording::Recording& recording,
                                                                      std::optional<core::Error>& why) {
    return allPictures<RecordedSceneCamera>(recording, why, recordedSceneCamera);
}

} // namespace teleta::pipeline
