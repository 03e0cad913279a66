// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/source_list.h"

#include "app/sources/array_file.h"
#include "backend/core/beside_file.h"
#include "backend/core/keys/toml_keys.h"
#include "backend/vision/gel/marker_gel_file.h"
#include "devices/camera/camera_device.h"
#include "devices/link/link_address.h"
#include "devices/ros/camera/ros_camera_file.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QString>

#include <utility>

namespace teleta::app {

namespace {

using core::Keys;
using core::Need;
using core::NumberRange;

/// Paths in a list are relative to its folder.
std::string besideList(const std::string& listPath, const std::string& path) {
    if (path.empty() || path.starts_with(":/"))
        return path;
    return core::besideFile(listPath, path);
}

/// Describes a key that holds a path. path stays as it is if the key is missing.
void describePath(Keys& keys, std::string_view key, const std::string& listPath, std::string& path,
                  std::string_view about, Need need = Need::required) {
    std::string given;
    keys.text(key, given, about, need);
    if (!given.empty())
        path = besideList(listPath, given);
}

void refuse(Keys& keys, std::string_view key, const core::Error& error) {
    keys.refuse(key, error.message, error.expected);
}

void describeScene(Keys& keys, const std::string& listPath, SceneRequest& request) {
    std::string given;
    keys.text("scene", given, "Scene file, or the name of one that comes with the program");
    if (!given.empty()) {
        request.path = besideList(listPath, given);
        // A name is found from every folder, unless a file beside the list has it.
        const QString named = QStringLiteral(":/scenes/%1.toml").arg(QString::fromStdString(given));
        if (!QFileInfo(QString::fromStdString(request.path)).isFile() && QFileInfo::exists(named))
            request.path = named.toStdString();
    }
    keys.whole("seed", request.seed, {0}, "Seed of its random numbers", Need::optional);
}

void describeRecording(Keys& keys, const std::string& listPath, CsvRequest& request) {
    std::string path;
    describePath(keys, "recording", listPath, path, "CSV file of the frames of an array");
    if (auto guessed = guessCsv(path))
        request = std::move(*guessed);
    else
        refuse(keys, "recording", guessed.error());
    const core::WholeRange side{1, core::ArrayLayout::kMaximumSide};
    const NumberRange positive = NumberRange::positive();
    keys.whole("rows", request.layout.rows, side, "Rows of taxels; otherwise guessed from the file",
               Need::optional);
    keys.whole("columns", request.layout.columns, side, "Taxels in a row; otherwise guessed from the file",
               Need::optional);
    double pitch_m = request.layout.pitchX_m;
    keys.number("pitch_m", pitch_m, positive,
                "Distance between neighbouring taxels; otherwise that of the guessed array", Need::optional);
    request.layout.setPitch_m(pitch_m);
    describePath(keys, "tare", listPath, request.tarePath,
                 "Recording of the unloaded array; otherwise a file beside it whose name says empty",
                 Need::optional);
    describePath(keys, "gains", listPath, request.gainsPath, "Gains of the taxels", Need::optional);
    keys.flag("inverted", request.inverted, "Readings fall under load");
    keys.number("gain", request.gain, positive, "Load units in a count of the file", Need::optional);
    keys.number("threshold", request.threshold_N, positive, "Load above which a taxel counts as touched",
                Need::optional);
    keys.text("unit", request.loadUnit, "Unit that is shown with every load", Need::optional);
    keys.number("rate_Hz", request.rate_Hz, NumberRange::notNegative(),
                "Frames a second; 0: at the times in the file", Need::optional);
    keys.number("speed", request.speed, NumberRange::between(0.01, 100.0),
                "How many times as fast it is played", Need::optional);
    keys.flag("loop", request.loop, "It starts again at its end");
}

/// All sources of a recording of this program.
void describePlaybacks(Keys& keys, const std::string& listPath, std::vector<SourceRequest>& requests) {
    std::string path;
    describePath(keys, "recording", listPath, path,
                 "Recording of this program (.teleta), with all of its sources");
    auto playbacks = recordingRequestsOf(path);
    if (!playbacks)
        refuse(keys, "recording", playbacks.error());
    bool loop = false;
    keys.flag("loop", loop, "It starts again at its end");
    for (RecordingRequest& playback : playbacks.value_or(std::vector<RecordingRequest>())) {
        playback.loop = loop;
        requests.emplace_back(std::move(playback));
    }
}

void describeWts(Keys& keys, const std::string& listPath, WtsRequest& request) {
    std::string text;
    keys.text("wts", text, "Weiss array: the path of its serial port, or `tcp://HOST:PORT`");
    if (auto address = wts::parseWtsAddress(text))
        request.config.address = std::move(*address);
    else
        refuse(keys, "wts", address.error());
    if (auto* serial = std::get_if<link::SerialAddress>(&request.config.address)) {
        serial->path = besideList(listPath, serial->path);
        keys.whole("baud", serial->baud, {9600, 4'000'000}, "Bits a second, of a serial port",
                   Need::optional);
    }
    keys.whole("delay_ms", request.config.delay_ms, {0, 65535}, "Time between frames; 0: as fast as possible",
               Need::optional);
    keys.flag("run_length", request.config.runLength, "The array compresses its frames");
    keys.flag("tare", request.config.tare, "The array tares itself at the start");
    keys.number("gain", request.gain, NumberRange::positive(), "Load units in a count of the array",
                Need::optional);
    describePath(keys, "gains", listPath, request.gainsPath, "Gains of the taxels", Need::optional);
    keys.number("threshold", request.threshold, NumberRange::positive(),
                "Load above which a taxel counts as touched; otherwise 1 % of full scale");
    keys.text("unit", request.loadUnit, "Unit that is shown with every load", Need::optional);
}

void describeCamera(Keys& keys, const std::string& listPath, CameraRequest& request) {
    keys.text("camera", request.source,
              "Number of a camera, a video, or a pattern of numbered pictures, as `frames/%04d.png`");
    if (!camera::isCameraNumber(request.source))
        request.source = besideList(listPath, request.source);
    describePath(keys, "camera_model", listPath, request.modelPath, "Camera file of its calibration");
    keys.flag("loop", request.loop, "A file starts again at its end");
}

void describeArm(Keys& keys, const std::string& listPath, ArmRequest& request) {
    describePath(
        keys, "arm", listPath, request.path,
        "File that describes an arm over ROS 2 (`kind = \"ros_arm\"`), or a Modbus device that reports "
        "the joints of one (`kind = \"modbus\"`)");
}

void describeTaxels(Keys& keys, const std::string& listPath, TaxelsRequest& request) {
    describePath(keys, "taxels", listPath, request.path,
                 "File that describes an array (`kind = \"taxels\"`, `\"magnetometers\"`, `\"xela\"` or "
                 "`\"ros_tactile\"`)");
}

void describeGel(Keys& keys, const std::string& listPath, GelRequest& request) {
    describePath(keys, "gel", listPath, request.path,
                 "File that describes a flat gel with markers (`kind = \"marker_gel\"`)");
    keys.flag("loop", request.loop, "A video starts again at its end");
}

template <typename Request>
void add(Keys& keys, const std::string& listPath, std::vector<SourceRequest>& requests,
         void (*describe)(Keys&, const std::string&, Request&)) {
    Request request;
    describe(keys, listPath, request);
    requests.emplace_back(std::move(request));
}

SourceKind kindOf(core::TomlTable& table) {
    if (table.has("scene"))
        return SourceKind::scene;
    if (table.has("wts"))
        return SourceKind::wts;
    if (table.has("camera"))
        return SourceKind::camera;
    if (table.has("arm"))
        return SourceKind::arm;
    if (table.has("taxels"))
        return SourceKind::taxels;
    if (table.has("gel"))
        return SourceKind::gel;
    if (table.has("scene_camera"))
        return SourceKind::sceneCamera;
    return isRecordingName(QString::fromStdString(table.text("recording"))) ? SourceKind::playback
                                                                            : SourceKind::recording;
}

} // namespace

void describeSceneCamera(core::Keys& keys, std::string_view key, const std::string& listPath,
                         SceneCameraRequest& request) {
    keys.text(key, request.source,
              "Camera that is only looked at: its number, a video, a pattern of numbered pictures, or a file "
              "that describes one over ROS 2 (`kind = \"ros_camera\"`)");
    if (!camera::isCameraNumber(request.source))
        request.source = besideList(listPath, request.source);
    keys.whole("width_px", request.width_px, {0, 16384}, "Width asked of a camera; 0: its own",
               Need::optional);
    keys.whole("height_px", request.height_px, {0, 16384}, "Height asked of a camera; 0: its own",
               Need::optional);
    keys.number("rate_Hz", request.rate_Hz, NumberRange::between(0.0, 1000.0),
                "Pictures a second asked of a camera; 0: its own", Need::optional);
    keys.flag("loop", request.loop, "A video starts again at its end");
}

void describeSource(core::Keys& keys, SourceKind kind, const std::string& listPath,
                    std::vector<SourceRequest>& requests) {
    switch (kind) {
    case SourceKind::scene:
        return add(keys, listPath, requests, describeScene);
    case SourceKind::recording:
        return add(keys, listPath, requests, describeRecording);
    case SourceKind::playback:
        return describePlaybacks(keys, listPath, requests);
    case SourceKind::wts:
        return add(keys, listPath, requests, describeWts);
    case SourceKind::camera:
        return add(keys, listPath, requests, describeCamera);
    case SourceKind::arm:
        return add(keys, listPath, requests, describeArm);
    case SourceKind::taxels:
        return add(keys, listPath, requests, describeTaxels);
    case SourceKind::gel:
        return add(keys, listPath, requests, describeGel);
    case SourceKind::sceneCamera: {
        SceneCameraRequest request;
        describeSceneCamera(keys, "scene_camera", listPath, request);
        requests.emplace_back(std::move(request));
        return;
    }
    }
}

namespace {

bool isOfKind(const core::TomlDocument& document, std::string_view kind) {
    return document.root().text("kind", std::string()) == kind;
}

bool describesArray(const core::TomlDocument& document) {
    return isArrayFileKind(document.root().text("kind", std::string()));
}

/// It has a key "source", too, but that is a text.
bool describesGel(const core::TomlDocument& document) {
    return isOfKind(document, "marker_gel");
}

bool describesSceneCamera(const core::TomlDocument& document) {
    return ros_camera::isRosCameraKind(document.root().text("kind", std::string()));
}

bool hasKind(const std::string& path, std::string_view kind) {
    const auto document = core::TomlDocument::open(path);
    return document && isOfKind(*document, kind);
}

} // namespace

bool isSourceList(const std::string& path) {
    const auto document = core::TomlDocument::open(path);
    return document && (document->root().has("source") || describesArray(*document) ||
                        describesGel(*document) || describesSceneCamera(*document));
}

bool isArmFile(const std::string& path) {
    return hasKind(path, "ros_arm") || isModbusFile(path);
}

bool isModbusFile(const std::string& path) {
    return hasKind(path, "modbus");
}

bool isSiteFile(const std::string& path) {
    return hasKind(path, "remote_site");
}

core::Expected<std::vector<SourceRequest>> readSourceList(const std::string& path) {
    TELETA_TRY(auto document, core::TomlDocument::open(path));
    core::TomlTable root = document.root();
    std::vector<SourceRequest> requests;
    if (describesArray(document)) {
        TELETA_CHECK(readArrayFile(path));
        requests.emplace_back(TaxelsRequest{path});
        return requests;
    }
    if (describesGel(document)) {
        TELETA_CHECK(vision::readMarkerGel(path));
        requests.emplace_back(GelRequest{path});
        return requests;
    }
    if (describesSceneCamera(document)) {
        TELETA_CHECK(ros_camera::readRosCamera(path));
        requests.emplace_back(SceneCameraRequest{path});
        return requests;
    }
    for (core::TomlTable& table : root.tables("source", 1)) {
        core::TomlKeys keys(table);
        describeSource(keys, kindOf(table), path, requests);
        keys.finish();
    }
    root.finish();
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return requests;
}

} // namespace teleta::app
