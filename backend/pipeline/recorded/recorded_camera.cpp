// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_camera.h"

#include "backend/core/data/json_document.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/stream_columns.h"
#include "backend/vision/calibration/camera_file.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace teleta::pipeline {

namespace {

constexpr double kLargest = 1e12;

/// Empty: the stream is one of references, of a flat gel, or of a scene camera.
core::Expected<std::optional<RecordedCamera>> recordedCamera(const recording::Recording& recording,
                                                             std::size_t number) {
    const recording::StreamInfo& stream = recording.streams()[number];
    if (recording::isColour(stream))
        return std::optional<RecordedCamera>();
    const auto document = core::JsonDocument::parse(stream.details, recording.path());
    if (!document)
        return notDescribed(stream, recording.path(), document.error());
    core::JsonReader reader(*document);
    const bool isGel = !reader.text(reader.root(), "marker_gel", {}).empty();
    if (isGel || reader.boolean(reader.root(), "reference", false))
        return std::optional<RecordedCamera>();
    const nlohmann::ordered_json& camera = reader.member(reader.root(), "camera");
    vision::BumpDetector::Settings bump;
    bump.speed_mPerS = reader.number(reader.root(), "bump_speed_m_per_s", 1e-9, kLargest, bump.speed_mPerS);
    bump.depth_m = reader.number(reader.root(), "bump_depth_m", 1e-9, kLargest, bump.depth_m);
    RecordedPictures pictures = readPictures(recording, number, reader);
    if (reader.error())
        return notDescribed(stream, recording.path(), *reader.error());
    auto model = vision::parseCamera(camera.dump(), recording.path());
    if (!model)
        return notDescribed(stream, recording.path(), model.error());
    return RecordedCamera{std::move(pictures), std::move(model->camera), bump};
}

} // namespace

recording::StreamInfo cameraStream(const std::string& name, const core::CameraDescription& description,
                                   const vision::CylinderCamera& camera,
                                   const vision::BumpDetector::Settings& bump, const std::string& reference) {
    const vision::CameraParameters& size = camera.camera().parameters();
    const vision::CalibrationSummary unknown;
    const nlohmann::ordered_json details{
        {"simulated", description.simulated},
        {"reference_stream", reference},
        {"bump_speed_m_per_s", bump.speed_mPerS},
        {"bump_depth_m", bump.depth_m},
        {"camera", vision::cameraJson({camera, unknown, nlohmann::ordered_json::object()})}};
    return {.name = name,
            .kind = recording::StreamKind::camera,
            .type = recording::ValueType::grey8,
            .source = description.name,
            .shape = {static_cast<std::size_t>(size.height_px), static_cast<std::size_t>(size.width_px)},
            .nominalRate_Hz = description.nominalRate_Hz,
            .details = details.dump()};
}

recording::StreamInfo referenceStream(const std::string& name, const core::CameraDescription& description) {
    return {.name = name,
            .kind = recording::StreamKind::camera,
            .type = recording::ValueType::grey8,
            .source = description.name,
            .shape = {0, 0},
            .details = nlohmann::ordered_json{{"reference", true}}.dump()};
}

recording::StreamInfo contactStream(const std::string& name, const core::CameraDescription& description) {
    return {.name = name,
            .kind = recording::StreamKind::contacts,
            .type = recording::ValueType::float64,
            .source = description.name,
            .shape = {kContactValues},
            .columns = recording::contactColumns()};
}

std::array<double, kContactValues> contactValues(const vision::FollowedContact& followed) {
    const vision::CameraContact& contact = followed.contact;
    const Eigen::Vector3d& place_m = contact.p_Sensor_Centre_m;
    const Eigen::Vector3d moved_m = followed.displacement_m();
    return {static_cast<double>(contact.id),
            contact.centre_px.x(),
            contact.centre_px.y(),
            place_m.x(),
            place_m.y(),
            place_m.z(),
            moved_m.x(),
            moved_m.y(),
            moved_m.z(),
            contact.area_px};
}

core::Expected<std::vector<RecordedCamera>> recordedCameras(const recording::Recording& recording,
                                                            std::optional<core::Error>& why) {
    return allPictures<RecordedCamera>(recording, why, recordedCamera);
}

core::Expected<core::GreyImage> firstReference(const recording::Recording& recording,
                                               const std::optional<std::size_t>& referenceStream) {
    if (!referenceStream)
        return core::GreyImage();
    recording::StreamReader reader = recording.reader(*referenceStream);
    core::TappedFrames block;
    for (;;) {
        const core::Expected<bool> any = reader.next(block);
        if (any)
            return *any ? block.image : core::GreyImage();
        if (any.error().kind != core::ErrorKind::badInput)
            return core::Unexpected(any.error());
        if (!reader.canGoOn())
            return core::GreyImage();
    }
}

} // namespace teleta::pipeline
