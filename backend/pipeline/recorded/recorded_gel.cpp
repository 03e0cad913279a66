// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_gel.h"

#include "backend/core/data/json_document.h"
#include "backend/pipeline/recorded/recorded_loads.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/recording/stream_columns.h"

#include <QCoreApplication>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

namespace teleta::pipeline {

namespace {

struct RecordedGelText {
    Q_DECLARE_TR_FUNCTIONS(RecordedStreams)
};

/// Nothing: the details have no calibration, or the reader has an error.
std::optional<GelLoads> loadsOf(core::JsonReader& reader) {
    auto calibration = readCalibration(reader, reader.root(), GelLoads::signalNames());
    if (!calibration)
        return std::nullopt;
    return GelLoads(*std::move(calibration));
}

/// Empty: the details of the stream describe no gel.
core::Expected<std::optional<RecordedGel>> recordedGel(const recording::Recording& recording,
                                                       std::size_t stream) {
    const recording::StreamInfo& info = recording.streams()[stream];
    const auto document = core::JsonDocument::parse(info.details, recording.path());
    if (!document)
        return notDescribed(info, recording.path(), document.error());
    core::JsonReader reader(*document);
    const std::string text = reader.text(reader.root(), "marker_gel", {});
    if (text.empty())
        return std::optional<RecordedGel>();
    RecordedPictures pictures = readPictures(recording, stream, reader);
    std::optional<GelLoads> loads = loadsOf(reader);
    if (reader.error())
        return notDescribed(info, recording.path(), *reader.error());
    auto file = vision::parseMarkerGel(text, recording.path());
    if (!file)
        return notDescribed(info, recording.path(), file.error());
    return RecordedGel{std::move(pictures), std::move(*file), std::move(loads)};
}

} // namespace

recording::StreamInfo gelStream(const std::string& name, const core::CameraDescription& description,
                                const vision::MarkerGelFile& file, const std::string& reference,
                                const equilibration::LoadCalibration* loads) {
    // The pictures are cropped and flipped by now, and come from nowhere else.
    vision::MarkerGelFile recorded = file;
    recorded.source.clear();
    recorded.width_px = recorded.height_px = 0;
    recorded.crop.clear();
    recorded.flipX = false;
    recorded.flipY = false;
    nlohmann::ordered_json details{{"simulated", description.simulated},
                                   {"reference_stream", reference},
                                   {"marker_gel", vision::markerGelText(recorded)}};
    // Of a video that was recorded again, or that a site plays.
    if (description.recorded)
        details["recorded"] = true;
    if (loads != nullptr)
        details["loads"] = loadsJson(*loads);
    const bool isCropped = file.crop.size() == 4;
    return {.name = name,
            .kind = recording::StreamKind::camera,
            .type = recording::ValueType::grey8,
            .source = description.name,
            .shape = {isCropped ? static_cast<std::size_t>(file.crop[3]) : 0,
                      isCropped ? static_cast<std::size_t>(file.crop[2]) : 0},
            .nominalRate_Hz = description.nominalRate_Hz,
            .details = details.dump()};
}

recording::StreamInfo gelReferenceStream(const std::string& name,
                                         const core::CameraDescription& description) {
    return {.name = name,
            .kind = recording::StreamKind::camera,
            .type = recording::ValueType::grey8,
            .source = description.name,
            .shape = {0, 0},
            .details = nlohmann::ordered_json{{"reference", true}, {"marker_gel_rest", true}}.dump()};
}

recording::StreamInfo gelContactStream(const std::string& name, const core::CameraDescription& description,
                                       const equilibration::LoadCalibration* loads) {
    std::vector<recording::Column> columns = recording::gelContactColumns();
    if (loads != nullptr)
        std::ranges::copy(loadColumns(loads->loads), std::back_inserter(columns));
    return {.name = name,
            .kind = recording::StreamKind::contacts,
            .type = recording::ValueType::float64,
            .source = description.name,
            .shape = {columns.size()},
            .columns = columns};
}

std::array<double, kGelContactValues> gelContactValues(const vision::GelContactState& contact) {
    return {static_cast<double>(contact.id),
            contact.centre_m.x(),
            contact.centre_m.y(),
            contact.area_m2,
            contact.normalProxy_m2,
            contact.shearProxy_m.x(),
            contact.shearProxy_m.y(),
            contact.torsion_rad,
            contact.slipIndex.value_or(std::numeric_limits<double>::quiet_NaN())};
}

core::GreyImage stackedReference(std::span<const core::GreyImage> pictures) {
    if (pictures.empty() || pictures.front().isEmpty())
        return {};
    const core::GreyImage& first = pictures.front();
    const std::size_t size = static_cast<std::size_t>(first.width_px) * first.height_px;
    auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    pixels->reserve(size * pictures.size());
    for (const core::GreyImage& picture : pictures) {
        if (picture.isEmpty() || picture.width_px != first.width_px || picture.height_px != first.height_px)
            return {};
        pixels->insert(pixels->end(), picture.pixels.get(), picture.pixels.get() + size);
    }
    return {{pixels, pixels->data()}, first.width_px, first.height_px * static_cast<int>(pictures.size())};
}

std::vector<core::GreyImage> unstackedReference(const core::GreyImage& stack, int width_px, int height_px) {
    if (stack.isEmpty() || width_px <= 0 || height_px <= 0 || stack.width_px != width_px ||
        stack.height_px % height_px != 0)
        return {};
    const std::size_t size = static_cast<std::size_t>(width_px) * height_px;
    std::vector<core::GreyImage> pictures;
    for (int i = 0; i < stack.height_px / height_px; ++i)
        pictures.push_back(
            {{stack.pixels, stack.pixels.get() + static_cast<std::size_t>(i) * size}, width_px, height_px});
    return pictures;
}

core::Expected<DescribedGel> gelOf(const recording::StreamInfo& stream, const std::string& file) {
    const auto document = core::JsonDocument::parse(stream.details, file);
    if (!document)
        return notDescribed(stream, file, document.error());
    core::JsonReader reader(*document);
    DescribedGel gel{.description = {.name = stream.source,
                                     .nominalRate_Hz = stream.nominalRate_Hz,
                                     .simulated = reader.boolean(reader.root(), "simulated", false),
                                     .recorded = reader.boolean(reader.root(), "recorded", false)},
                     .file = {}};
    const std::string text = reader.text(reader.root(), "marker_gel", {});
    gel.loads = loadsOf(reader);
    if (reader.error())
        return notDescribed(stream, file, *reader.error());
    if (text.empty())
        return notDescribed(stream, file, RecordedGelText::tr("it is no gel with markers"));
    auto parsed = vision::parseMarkerGel(text, file);
    if (!parsed)
        return notDescribed(stream, file, parsed.error());
    gel.file = std::move(*parsed);
    return gel;
}

core::Expected<std::vector<RecordedGel>> recordedGels(const recording::Recording& recording,
                                                      std::optional<core::Error>& why) {
    return allPictures<RecordedGel>(recording, why, recordedGel);
}

} // namespace teleta::pipeline
