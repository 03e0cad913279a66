// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/source_list.h"

#include "backend/core/data/toml_table.h"
#include "devices/camera/camera_feed.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>

#include <utility>

namespace teleta::console {

namespace {

std::string besideList(const std::string& listPath, const std::string& path) {
    if (path.empty() || path.starts_with(":/"))
        return path;
    return QFileInfo(QString::fromStdString(listPath))
        .dir()
        .filePath(QString::fromStdString(path))
        .toStdString();
}

SceneRequest readSceneSource(core::TomlTable& table, const std::string& listPath) {
    SceneRequest request;
    request.path = besideList(listPath, table.text("scene"));
    request.seed =
        static_cast<std::uint64_t>(table.integer("seed", 0, std::numeric_limits<long long>::max(), 1));
    return request;
}

RecordingRequest readRecordingSource(core::TomlTable& table, const std::string& listPath) {
    const std::string path = besideList(listPath, table.text("recording"));
    RecordingRequest request;
    if (auto guessed = guessRecording(path))
        request = std::move(*guessed);
    else
        table.fail("recording", guessed.error().message, guessed.error().expected);
    request.layout.rows =
        static_cast<int>(table.integer("rows", 1, core::ArrayLayout::kMaximumSide, request.layout.rows));
    request.layout.columns = static_cast<int>(
        table.integer("columns", 1, core::ArrayLayout::kMaximumSide, request.layout.columns));
    request.layout.pitch_m = table.number("pitch_m", core::NumberRange::positive(), request.layout.pitch_m);
    if (table.has("tare"))
        request.tarePath = besideList(listPath, table.text("tare"));
    if (table.has("gains"))
        request.gainsPath = besideList(listPath, table.text("gains"));
    request.inverted = table.boolean("inverted", request.inverted);
    request.gain = table.number("gain", core::NumberRange::positive(), request.gain);
    request.threshold_N = table.number("threshold", core::NumberRange::positive(), request.threshold_N);
    request.loadUnit = table.text("unit", request.loadUnit);
    request.rate_Hz = table.number("rate_Hz", core::NumberRange::notNegative(), request.rate_Hz);
    request.speed = table.number("speed", core::NumberRange::between(0.01, 100.0), request.speed);
    request.loop = table.boolean("loop", request.loop);
    return request;
}

/// All sources of a recording of this program.
void readPlaybacks(core::TomlTable& table, const std::string& listPath,
                   std::vector<SourceRequest>& requests) {
    auto playbacks = playbacksOf(besideList(listPath, table.text("recording")));
    if (!playbacks)
        table.fail("recording", playbacks.error().message, playbacks.error().expected);
    const bool loop = table.boolean("loop", false);
    for (PlaybackRequest& playback : playbacks.value_or(std::vector<PlaybackRequest>())) {
        playback.loop = loop;
        requests.emplace_back(std::move(playback));
    }
}

WtsRequest readWtsSource(core::TomlTable& table, const std::string& listPath) {
    WtsRequest request;
    if (auto address = wts::parseWtsAddress(table.text("wts")))
        request.config.address = std::move(*address);
    else
        table.fail("wts", address.error().message, address.error().expected);
    if (auto* serial = std::get_if<wts::SerialAddress>(&request.config.address)) {
        serial->path = besideList(listPath, serial->path);
        serial->baud = static_cast<int>(table.integer("baud", 9600, 4'000'000, serial->baud));
    }
    request.config.delay_ms =
        static_cast<std::uint16_t>(table.integer("delay_ms", 0, 65535, request.config.delay_ms));
    request.config.runLength = table.boolean("run_length", request.config.runLength);
    request.config.tare = table.boolean("tare", request.config.tare);
    request.gain = table.number("gain", core::NumberRange::positive(), request.gain);
    if (table.has("gains"))
        request.gainsPath = besideList(listPath, table.text("gains"));
    if (table.has("threshold"))
        request.threshold = table.number("threshold", core::NumberRange::positive());
    request.loadUnit = table.text("unit", request.loadUnit);
    return request;
}

CameraRequest readCameraSource(core::TomlTable& table, const std::string& listPath) {
    CameraRequest request;
    request.source = table.text("camera");
    if (!camera::isCameraNumber(request.source))
        request.source = besideList(listPath, request.source);
    request.modelPath = besideList(listPath, table.text("camera_model"));
    request.loop = table.boolean("loop", request.loop);
    return request;
}

} // namespace

bool isSourceList(const std::string& path) {
    const auto document = core::TomlDocument::open(path);
    return document && document->root().has("source");
}

core::Expected<std::vector<SourceRequest>> readSourceList(const std::string& path) {
    auto document = core::TomlDocument::open(path);
    if (!document)
        return core::Unexpected(document.error());
    core::TomlTable root = document->root();
    std::vector<SourceRequest> requests;
    for (core::TomlTable& table : root.tables("source", 1)) {
        if (table.has("scene"))
            requests.emplace_back(readSceneSource(table, path));
        else if (table.has("wts"))
            requests.emplace_back(readWtsSource(table, path));
        else if (table.has("camera"))
            requests.emplace_back(readCameraSource(table, path));
        else if (isRecordingName(QString::fromStdString(table.text("recording"))))
            readPlaybacks(table, path, requests);
        else
            requests.emplace_back(readRecordingSource(table, path));
        table.finish();
    }
    root.finish();
    if (document->firstError())
        return core::Unexpected(*document->firstError());
    return requests;
}

} // namespace teleta::console
