// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/base/source_request.h"

#include "app/common/scene_file.h"
#include "backend/core/data/frame_file.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/scene_run/base/scene_settings.h"
#include "backend/scene_run/camera/scene_reaction.h"
#include "backend/simulation/arm/teleoperated_arm.h"
#include "backend/simulation/array/simulated_array.h"
#include "backend/simulation/camera/tube_camera.h"
#include "backend/simulation/servo/servo_array.h"
#include "backend/vision/calibration/camera_file.h"
#include "devices/camera/camera_device.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/recorded_device.h"
#include "devices/simulated/simulated_arm_device.h"
#include "devices/simulated/simulated_array_device.h"
#include "devices/simulated/simulated_camera_device.h"
#include "devices/wts/wts_device.h"

#include <QDir>
#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

namespace teleta::console {

namespace {

struct KnownArray {
    int rows;
    int columns;
    double pitch_m;
    const char* unit;
};

/// Weiss WTS0614; Sensomatt and Tactilus bed arrays of the PoPu recordings (their pitch is not published: 50
/// and 25 mm are round numbers that give a bed's size).
constexpr std::array kKnownArrays{KnownArray{6, 14, 0.0034, "N"}, KnownArray{12, 6, 0.05, "counts"},
                                  KnownArray{64, 27, 0.025, "counts"}};

/// What an array of so many taxels is likely to be. The values of one that is not known are counts until
/// somebody says otherwise.
void guessArray(std::size_t taxels, RecordingRequest& request) {
    request.loadUnit = "counts";
    for (const KnownArray& known : kKnownArrays) {
        if (static_cast<std::size_t>(known.rows) * static_cast<std::size_t>(known.columns) == taxels) {
            request.layout = {known.rows, known.columns, known.pitch_m};
            request.loadUnit = known.unit;
            return;
        }
    }
    std::size_t rows = 1;
    for (std::size_t side = 1; side * side <= taxels; ++side) {
        if (taxels % side == 0)
            rows = side;
    }
    request.layout.rows = static_cast<int>(rows);
    request.layout.columns = static_cast<int>(taxels / rows);
}

/// The unloaded recording beside a recording: "array_left1.csv" -> "array_empty*.csv".
std::string unloadedBeside(const std::string& path) {
    const QFileInfo file(QString::fromStdString(path));
    const qsizetype separator = file.completeBaseName().lastIndexOf(QLatin1Char('_'));
    if (separator <= 0)
        return {};
    const QString prefix = file.completeBaseName().left(separator + 1);
    const QStringList found =
        file.dir().entryList({prefix + QStringLiteral("empty*.csv")}, QDir::Files, QDir::Name);
    if (found.isEmpty() || found.front() == file.fileName())
        return {};
    return file.dir().filePath(found.front()).toStdString();
}

pipeline::ChannelSettings settingsFor(double threshold_N, const std::string& unit) {
    pipeline::ChannelSettings settings;
    settings.features.threshold_N = threshold_N;
    settings.segmentation.threshold_N = threshold_N;
    settings.loadUnit = unit;
    return settings;
}

/// Reads the gains of the taxels, when a file of them is named.
core::Expected<void> takeGains(const std::string& path, const core::ArrayLayout& layout,
                               pipeline::ChannelSettings& settings) {
    if (path.empty())
        return {};
    const auto gains = equilibration::readTaxelGains(path, layout);
    if (!gains)
        return core::Unexpected(gains.error());
    settings.conditioning.taxelGain = gains->values();
    return {};
}

core::Expected<pipeline::OpenedSource> openRecording(const RecordingRequest& request) {
    pipeline::ChannelSettings settings = settingsFor(request.threshold_N, request.loadUnit);
    settings.conditioning.gain = request.gain;
    settings.conditioning.inverted = request.inverted;
    if (!request.tarePath.empty()) {
        auto tare = core::readTare(request.tarePath, request.layout);
        if (!tare)
            return core::Unexpected(tare.error());
        settings.conditioning.tare = std::move(*tare);
    }
    if (const auto taken = takeGains(request.gainsPath, request.layout, settings); !taken)
        return core::Unexpected(taken.error());
    replay::CsvConfig config;
    config.path = request.path;
    config.layout = request.layout;
    config.unit = request.loadUnit;
    if (request.rate_Hz > 0.0)
        config.rate_Hz = request.rate_Hz;
    config.speed = request.speed;
    config.loop = request.loop;
    auto player = replay::RecordedPlayer::open(std::move(config));
    if (!player)
        return core::Unexpected(player.error());
    return pipeline::OpenedSource{std::make_unique<replay::RecordedArray>(*player), std::move(settings)};
}

core::Expected<pipeline::OpenedSource> openArm(const scene::Scene& scene, std::uint64_t seed,
                                               const core::StopSwitch& stop) {
    auto generator = simulation::makeArm(scene, seed);
    if (!generator)
        return core::Unexpected(generator.error());
    auto arm = std::make_unique<simulated::SimulatedArmDevice>(std::move(*generator), stop);
    auto skin = arm->makeSkin();
    return pipeline::OpenedSource{std::move(skin), scene_run::channelSettings(scene), std::move(arm), {}};
}

pipeline::OpenedSource openedArray(std::unique_ptr<core::FrameGenerator> array, const scene::Scene& scene,
                                   const core::StopSwitch& stop) {
    auto control = std::make_shared<core::SceneControl>();
    simulated::SimulatedArrayConfig config;
    config.scene = control;
    pipeline::OpenedSource opened{
        std::make_unique<simulated::SimulatedArrayDevice>(std::move(array), stop, std::move(config)),
        scene_run::channelSettings(scene)};
    opened.scene = std::move(control);
    return opened;
}

core::Expected<pipeline::OpenedSource> openServo(const scene::Scene& scene, std::uint64_t seed,
                                                 const core::StopSwitch& stop) {
    auto link = std::make_shared<servo::ServoLink>();
    auto array = simulation::makeServoArray(scene, seed, link);
    if (!array)
        return core::Unexpected(array.error());
    pipeline::OpenedSource opened = openedArray(std::move(*array), scene, stop);
    opened.servo = std::move(link);
    return opened;
}

pipeline::OpenedSource openedCamera(std::shared_ptr<pipeline::CameraChannel> channel) {
    pipeline::OpenedSource opened;
    opened.camera = std::move(channel);
    return opened;
}

core::Expected<pipeline::OpenedSource> openTube(const scene::Scene& scene, std::uint64_t seed,
                                                const core::StopSwitch& stop) {
    auto link = std::make_shared<simulation::CarrierLink>();
    auto control = std::make_shared<core::SceneControl>();
    auto made = simulation::makeTubeCamera(scene, seed, link, control);
    if (!made)
        return core::Unexpected(made.error());
    const scene::CameraWorld& world = scene.camera();
    std::unique_ptr<pipeline::CameraReaction> reaction;
    if (!std::holds_alternative<scene::NoReaction>(world.reaction))
        reaction = std::make_unique<scene_run::SceneReaction>(world, 1.0 / scene.rate_Hz, link);
    auto channel = pipeline::CameraChannel::make(
        std::make_unique<simulated::SimulatedCameraDevice>(std::move(made->generator), stop), made->camera,
        stop, std::move(reaction), {.tracker = scene_run::trackerSettings(world), .contacts = {}});
    if (!channel)
        return core::Unexpected(channel.error());
    pipeline::OpenedSource opened = openedCamera(std::move(*channel));
    opened.scene = std::move(control);
    return opened;
}

core::Expected<pipeline::OpenedSource> openCamera(const CameraRequest& request,
                                                  const core::StopSwitch& stop) {
    auto model = vision::readCamera(request.modelPath);
    if (!model)
        return core::Unexpected(model.error());
    camera::CameraConfig config;
    config.source = request.source;
    config.width_px = model->camera.camera().parameters().width_px;
    config.height_px = model->camera.camera().parameters().height_px;
    config.loop = request.loop;
    auto feed = camera::CameraDevice::open(std::move(config));
    if (!feed)
        return core::Unexpected(feed.error());
    auto channel = pipeline::CameraChannel::make(std::move(*feed), model->camera, stop);
    if (!channel)
        return core::Unexpected(channel.error());
    return openedCamera(std::move(*channel));
}

core::Expected<pipeline::OpenedSource> openScene(const SceneRequest& request, const core::StopSwitch& stop) {
    auto scene = app::readScene(request.path);
    if (!scene)
        return core::Unexpected(scene.error());
    if (scene->isArm())
        return openArm(*scene, request.seed, stop);
    if (scene->isServo())
        return openServo(*scene, request.seed, stop);
    if (scene->isCamera())
        return openTube(*scene, request.seed, stop);
    auto array = simulation::makeTactileArray(*scene, request.seed);
    if (!array)
        return core::Unexpected(array.error());
    return openedArray(std::move(*array), *scene, stop);
}

core::Expected<pipeline::OpenedSource> openWts(const WtsRequest& request) {
    constexpr double kThresholdShare = 0.01;
    auto source = wts::WtsDevice::open(request.config);
    if (!source)
        return core::Unexpected(source.error());
    const double fullScale = (*source)->matrix().fullScale * request.gain;
    pipeline::ChannelSettings settings =
        settingsFor(request.threshold.value_or(kThresholdShare * fullScale), request.loadUnit);
    settings.conditioning.gain = request.gain;
    if (const auto taken = takeGains(request.gainsPath, (*source)->description().layout, settings); !taken)
        return core::Unexpected(taken.error());
    return pipeline::OpenedSource{std::move(*source), std::move(settings)};
}

/// The name of the link, or else nothing.
QString linkOf(const SourceRequest& request) {
    if (const auto* camera = std::get_if<CameraRequest>(&request);
        camera && camera::isCameraNumber(camera->source))
        return QStringLiteral("/dev/video") + QString::fromStdString(camera->source);
    const auto* connected = std::get_if<WtsRequest>(&request);
    return connected != nullptr ? QString::fromStdString(wts::displayName(connected->config.address))
                                : QString();
}

QString pathOf(const SourceRequest& request) {
    if (const auto* recording = std::get_if<RecordingRequest>(&request))
        return QString::fromStdString(recording->path);
    if (const auto* camera = std::get_if<CameraRequest>(&request))
        return QString::fromStdString(camera->source);
    if (const auto* playback = std::get_if<PlaybackRequest>(&request))
        return QString::fromStdString(playback->path);
    const auto* scene = std::get_if<SceneRequest>(&request);
    return scene != nullptr ? QString::fromStdString(scene->path) : QString();
}

} // namespace

QString displayName(const SourceRequest& request) {
    if (const auto* playback = std::get_if<PlaybackRequest>(&request); playback && !playback->source.empty())
        return QStringLiteral("%1 (%2)").arg(
            QFileInfo(QString::fromStdString(playback->path)).completeBaseName(),
            QString::fromStdString(playback->source));
    const QString link = linkOf(request);
    return link.isEmpty() ? QFileInfo(pathOf(request)).completeBaseName() : link;
}

QString fileName(const SourceRequest& request) {
    const QString link = linkOf(request);
    return link.isEmpty() ? QFileInfo(pathOf(request)).fileName() : link;
}

pipeline::SourceFactory makeSourceFactory(SourceRequest request, const core::StopSwitch& stop) {
    return [request = std::move(request), &stop] {
        if (const auto* recording = std::get_if<RecordingRequest>(&request))
            return openRecording(*recording);
        if (const auto* connected = std::get_if<WtsRequest>(&request))
            return openWts(*connected);
        if (const auto* camera = std::get_if<CameraRequest>(&request))
            return openCamera(*camera, stop);
        if (const auto* playback = std::get_if<PlaybackRequest>(&request))
            return openPlayback(*playback, stop);
        return openScene(std::get<SceneRequest>(request), stop);
    };
}

core::Expected<RecordingRequest> guessRecording(const std::string& path) {
    const auto taxels = core::FrameFile::countTaxels(path);
    if (!taxels)
        return core::Unexpected(taxels.error());
    RecordingRequest request;
    request.path = path;
    guessArray(*taxels, request);
    request.tarePath = unloadedBeside(path);
    return request;
}

} // namespace teleta::console
