// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/source_request.h"

#include "app/common/scene_file.h"
#include "app/sources/array_file.h"
#include "app/sources/source_list.h"
#include "backend/core/beside_file.h"
#include "backend/core/data/array_guess.h"
#include "backend/core/data/frame_file.h"
#include "backend/core/failure.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/pipeline/gel_channel.h"
#include "backend/pipeline/joint_channel.h"
#include "backend/pipeline/scene_camera_channel.h"
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/scene_run/base/scene_settings.h"
#include "backend/scene_run/camera/scene_reaction.h"
#include "backend/scene_run/gel/gel_scene_reaction.h"
#include "backend/scene_run/gel/scene_gel.h"
#include "backend/simulation/arm/teleoperated_arm.h"
#include "backend/simulation/array/simulated_array.h"
#include "backend/simulation/camera/gel/gel_camera.h"
#include "backend/simulation/camera/tube_camera.h"
#include "backend/simulation/servo/servo_array.h"
#include "backend/vision/calibration/camera_file.h"
#include "backend/vision/gel/marker_gel_file.h"
#include "devices/camera/camera_device.h"
#include "devices/link/link_address.h"
#include "devices/modbus/modbus_joints.h"
#include "devices/modbus/register_map.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/recorded_device.h"
#include "devices/ros/array/ros_array.h"
#include "devices/ros/camera/ros_camera.h"
#include "devices/ros/ros_arm.h"
#include "devices/simulated/simulated_arm_device.h"
#include "devices/simulated/simulated_array_device.h"
#include "devices/simulated/simulated_camera_device.h"
#include "devices/taxels/taxels_device.h"
#include "devices/taxels/taxels_file.h"
#include "devices/taxels/taxels_probe.h"
#include "devices/wts/wts_device.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>

#include <utility>

namespace teleta::app {

namespace {

struct SourceText {
    Q_DECLARE_TR_FUNCTIONS(SourceText)
};

using Opened = std::shared_ptr<pipeline::Channel>;

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
    TELETA_TRY(const auto gains, equilibration::readTaxelGains(path, layout));
    settings.conditioning.taxelGain = gains.values();
    return {};
}

core::Expected<Opened> openCsv(const CsvRequest& request) {
    pipeline::ChannelSettings settings = settingsFor(request.threshold_N, request.loadUnit);
    settings.conditioning.gain = request.gain;
    settings.conditioning.inverted = request.inverted;
    if (!request.tarePath.empty()) {
        auto tare = core::readTare(request.tarePath, request.layout);
        TELETA_CHECK(tare);
        settings.conditioning.tare = std::move(*tare);
    }
    TELETA_CHECK(takeGains(request.gainsPath, request.layout, settings));
    replay::CsvConfig config;
    config.path = request.path;
    config.layout = request.layout;
    config.unit = request.loadUnit;
    if (request.rate_Hz > 0.0)
        config.rate_Hz = request.rate_Hz;
    config.speed = request.speed;
    config.loop = request.loop;
    TELETA_TRY(auto player, replay::RecordedPlayer::open(std::move(config)));
    return std::make_shared<pipeline::TouchChannel>(
        std::make_unique<replay::RecordedArray>(std::move(player)), std::move(settings));
}

core::Expected<Opened> openArmScene(const scene::Scene& scene, std::uint64_t seed,
                                    const core::StopSwitch& stop) {
    TELETA_TRY(auto generator, simulation::makeArm(scene, seed));
    auto arm = std::make_unique<simulated::SimulatedArmDevice>(std::move(generator), stop);
    auto skin = std::make_shared<pipeline::TouchChannel>(arm->makeSkin(), scene_run::channelSettings(scene));
    return std::make_shared<pipeline::ArmChannel>(std::move(arm), std::move(skin));
}

Opened openedArray(std::unique_ptr<core::FrameGenerator> array, const scene::Scene& scene,
                   const core::StopSwitch& stop, std::shared_ptr<servo::ServoLink> servo = nullptr) {
    auto control = std::make_shared<core::SceneControl>();
    simulated::SimulatedArrayConfig config;
    config.scene = control;
    auto channel = std::make_shared<pipeline::TouchChannel>(
        std::make_unique<simulated::SimulatedArrayDevice>(std::move(array), stop, std::move(config)),
        scene_run::channelSettings(scene), std::move(servo));
    channel->setScene(std::move(control));
    return channel;
}

core::Expected<Opened> openServo(const scene::Scene& scene, std::uint64_t seed,
                                 const core::StopSwitch& stop) {
    auto link = std::make_shared<servo::ServoLink>();
    TELETA_TRY(auto array, simulation::makeServoArray(scene, seed, link));
    return openedArray(std::move(array), scene, stop, std::move(link));
}

core::Expected<Opened> openTube(const scene::Scene& scene, std::uint64_t seed, const core::StopSwitch& stop) {
    auto link = std::make_shared<simulation::CarrierLink>();
    auto control = std::make_shared<core::SceneControl>();
    TELETA_TRY(auto made, simulation::makeTubeCamera(scene, seed, link, control));
    const scene::CameraWorld& world = scene.camera();
    std::unique_ptr<pipeline::CameraReaction> reaction;
    if (!std::holds_alternative<scene::NoReaction>(world.reaction))
        reaction = std::make_unique<scene_run::SceneReaction>(world, 1.0 / scene.rate_Hz, link);
    auto channel = pipeline::CameraChannel::make(
        std::make_unique<simulated::SimulatedCameraDevice>(std::move(made.generator), stop), made.camera,
        stop, std::move(reaction), {.tracker = scene_run::trackerSettings(world), .contacts = {}});
    TELETA_CHECK(channel);
    (*channel)->setScene(std::move(control));
    return *channel;
}

core::Expected<Opened> openGelScene(const scene::Scene& scene, std::uint64_t seed,
                                    const core::StopSwitch& stop) {
    auto control = std::make_shared<core::SceneControl>();
    const bool reacts = !std::holds_alternative<scene::NoReaction>(scene.gel().reaction);
    auto link = reacts ? std::make_shared<simulation::CarrierLink>() : nullptr;
    TELETA_TRY(auto generator, simulation::makeGelCamera(scene, seed, control, link));
    auto channel = std::make_shared<pipeline::GelChannel>(
        std::make_unique<simulated::SimulatedCameraDevice>(std::move(generator), stop),
        scene_run::gelFile(scene));
    if (reacts)
        channel->setReaction(
            std::make_unique<scene_run::GelSceneReaction>(scene.gel(), 1.0 / scene.rate_Hz, std::move(link)),
            stop);
    channel->setScene(std::move(control));
    return channel;
}

core::Expected<Opened> openCamera(const CameraRequest& request, const core::StopSwitch& stop) {
    TELETA_TRY(auto model, vision::readCamera(request.modelPath));
    camera::CameraConfig config;
    config.source = request.source;
    config.width_px = model.camera.camera().parameters().width_px;
    config.height_px = model.camera.camera().parameters().height_px;
    config.loop = request.loop;
    TELETA_TRY(auto feed, camera::CameraDevice::open(std::move(config)));
    auto channel = pipeline::CameraChannel::make(std::move(feed), model.camera, stop);
    TELETA_CHECK(channel);
    return *channel;
}

core::Expected<Opened> openGel(const GelRequest& request) {
    TELETA_TRY(auto file, vision::readMarkerGel(request.path));
    if (file.source.empty())
        return core::failed(core::ErrorKind::badInput,
                            SourceText::tr("the sensor file names no camera and no video"),
                            SourceText::tr("a key \"source\""), {request.path});
    camera::CameraConfig config;
    config.source =
        camera::isCameraNumber(file.source) ? file.source : core::besideFile(request.path, file.source);
    config.width_px = file.width_px;
    config.height_px = file.height_px;
    config.rate_Hz = file.rate_Hz;
    config.channel = static_cast<camera::VideoChannel>(file.channel); // of the same order
    config.loop = request.loop;
    TELETA_TRY(auto feed, camera::CameraDevice::open(std::move(config)));
    std::optional<pipeline::GelLoads> loads;
    if (!file.loads.empty()) {
        TELETA_TRY(loads, pipeline::GelLoads::read(core::besideFile(request.path, file.loads)));
    }
    auto channel = std::make_shared<pipeline::GelChannel>(std::move(feed), std::move(file));
    channel->setLoads(std::move(loads));
    return channel;
}

bool isDescription(const SceneCameraRequest& request) {
    return QString::fromStdString(request.source).endsWith(QLatin1String(".toml"), Qt::CaseInsensitive);
}

core::Expected<Opened> openSceneCamera(const SceneCameraRequest& request) {
    if (isDescription(request)) {
        TELETA_TRY(auto file, ros_camera::readRosCamera(request.source));
        TELETA_TRY(auto source, ros_camera::RosCamera::open(std::move(file)));
        return std::make_shared<pipeline::SceneCameraChannel>(std::move(source));
    }
    camera::CameraConfig config;
    config.source = request.source;
    config.width_px = request.width_px;
    config.height_px = request.height_px;
    config.rate_Hz = request.rate_Hz;
    config.channel = camera::VideoChannel::colour;
    config.loop = request.loop;
    TELETA_TRY(auto feed, camera::CameraDevice::open(std::move(config)));
    return std::make_shared<pipeline::SceneCameraChannel>(std::move(feed));
}

/// Joints that can be looked at, not moved.
core::Expected<Opened> openModbusJoints(const std::string& path) {
    TELETA_TRY(const auto map, modbus::readRegisterMap(path));
    TELETA_TRY(auto joints, modbus::makeModbusJoints(map, core::ArmDescription()));
    return std::make_shared<pipeline::JointChannel>(std::move(joints));
}

/// The pad that an arm's file names: an array with a file of its own, or the only source of a list.
core::Expected<std::shared_ptr<pipeline::TouchChannel>>
openPad(const std::string& path, const core::StopSwitch& stop, const std::function<bool()>& cancelled) {
    TELETA_TRY(auto list, readSourceList(path));
    const bool isOne = list.size() == 1 && (std::holds_alternative<TaxelsRequest>(list.front()) ||
                                            std::holds_alternative<WtsRequest>(list.front()));
    if (!isOne)
        return core::failed(core::ErrorKind::badInput, SourceText::tr("it is not the file of one pad"),
                            SourceText::tr("an array, or a list with one: taxels or wts"), {path});
    TELETA_TRY(const auto opened, makeSourceFactory(std::move(list.front()), stop, cancelled)());
    return std::dynamic_pointer_cast<pipeline::TouchChannel>(opened);
}

/// Without a pad what the arm touches is not known.
core::Expected<Opened> openArm(const ArmRequest& request, const core::StopSwitch& stop,
                               const std::function<bool()>& cancelled) {
    if (isModbusFile(request.path))
        return openModbusJoints(request.path);
    TELETA_TRY(const auto file, ros_arm::readRosArm(request.path));
    TELETA_TRY(auto arm, ros_arm::RosArm::open(file, stop, cancelled, request.required));
    auto chain = arm->sharedChain();
    if (!file.touch || file.touch->array.empty())
        return std::make_shared<pipeline::JointChannel>(std::move(arm), std::move(chain), file.meshPath);
    TELETA_TRY(auto pad, openPad(file.touch->array, stop, cancelled));
    TELETA_TRY(auto channel, pipeline::ArmChannel::withPad(std::move(arm), std::move(pad), std::move(chain),
                                                           file.touch->pad, file.meshPath));
    return channel;
}

core::Expected<Opened> openScene(const SceneRequest& request, const core::StopSwitch& stop) {
    TELETA_TRY(auto scene, readScene(request.path));
    if (scene.isArm())
        return openArmScene(scene, request.seed, stop);
    if (scene.isServo())
        return openServo(scene, request.seed, stop);
    if (scene.isCamera())
        return openTube(scene, request.seed, stop);
    if (scene.isGel())
        return openGelScene(scene, request.seed, stop);
    TELETA_TRY(auto array, simulation::makeTactileArray(scene, request.seed));
    return openedArray(std::move(array), scene, stop);
}

core::Expected<Opened> openWts(const WtsRequest& request) {
    constexpr double kThresholdShare = 0.01;
    TELETA_TRY(auto source, wts::WtsDevice::open(request.config));
    const double fullScale = source->matrix().fullScale * request.gain;
    pipeline::ChannelSettings settings =
        settingsFor(request.threshold.value_or(kThresholdShare * fullScale), request.loadUnit);
    settings.conditioning.gain = request.gain;
    TELETA_CHECK(takeGains(request.gainsPath, source->description().layout.grid(), settings));
    return std::make_shared<pipeline::TouchChannel>(std::move(source), std::move(settings));
}

core::Expected<Opened> openRosArray(ros_array::RosArrayFile file) {
    pipeline::ChannelSettings settings = settingsFor(file.threshold, file.unit);
    TELETA_TRY(auto source, ros_array::RosArray::open(std::move(file)));
    return std::make_shared<pipeline::TouchChannel>(std::move(source), std::move(settings));
}

core::Expected<Opened> openTaxels(const TaxelsRequest& request, const std::function<bool()>& cancelled) {
    TELETA_TRY(auto described, readArrayFile(request.path));
    if (auto* ros = std::get_if<ros_array::RosArrayFile>(&described))
        return openRosArray(std::move(*ros));
    auto& file = std::get<taxels::TaxelsFile>(described);
    pipeline::ChannelSettings settings = settingsFor(file.touchedFrom(), file.grid.loadUnit());
    settings.conditioning.gain = file.grid.newtonsPerUnit().value_or(1.0);
    std::optional<pipeline::FrameLoads> loads;
    if (!file.loads.empty()) {
        TELETA_TRY(loads, pipeline::FrameLoads::read(file.loads, file.grid.layout(), settings.loadUnit));
    }
    if (file.restFrames > 0) {
        TELETA_TRY(auto rest, taxels::measureRest(file, cancelled));
        settings.conditioning.tare = std::move(rest.values);
        settings.tareTemperatures_degC = std::move(rest.temperatures_degC);
    }
    TELETA_TRY(auto source, taxels::TaxelsDevice::open(std::move(file)));
    auto channel = std::make_shared<pipeline::TouchChannel>(std::move(source), std::move(settings));
    channel->setLoads(std::move(loads));
    return channel;
}

/// The name of the link, or else nothing.
QString linkOf(const SourceRequest& request) {
    if (const auto* camera = std::get_if<CameraRequest>(&request);
        camera && camera::isCameraNumber(camera->source))
        return QStringLiteral("/dev/video") + QString::fromStdString(camera->source);
    if (const auto* camera = std::get_if<SceneCameraRequest>(&request);
        camera && camera::isCameraNumber(camera->source))
        return QStringLiteral("/dev/video") + QString::fromStdString(camera->source);
    const auto* connected = std::get_if<WtsRequest>(&request);
    return connected != nullptr ? QString::fromStdString(link::displayName(connected->config.address))
                                : QString();
}

QString pathOf(const SourceRequest& request) {
    if (const auto* csv = std::get_if<CsvRequest>(&request))
        return QString::fromStdString(csv->path);
    if (const auto* camera = std::get_if<CameraRequest>(&request))
        return QString::fromStdString(camera->source);
    if (const auto* recording = std::get_if<RecordingRequest>(&request))
        return QString::fromStdString(recording->path);
    if (const auto* arm = std::get_if<ArmRequest>(&request))
        return QString::fromStdString(arm->path);
    if (const auto* remote = std::get_if<SiteRequest>(&request))
        return QString::fromStdString(remote->path);
    if (const auto* described = std::get_if<TaxelsRequest>(&request))
        return QString::fromStdString(described->path);
    if (const auto* gel = std::get_if<GelRequest>(&request))
        return QString::fromStdString(gel->path);
    if (const auto* camera = std::get_if<SceneCameraRequest>(&request))
        return QString::fromStdString(camera->source);
    const auto* scene = std::get_if<SceneRequest>(&request);
    return scene != nullptr ? QString::fromStdString(scene->path) : QString();
}

/// Local time in the name of a recording, "20261130T091014Z-...". Empty: it has another name.
QString localTimeOf(const QString& file) {
    const auto named =
        QDateTime::fromString(file.section(QLatin1Char('-'), 0, 0), QStringLiteral("yyyyMMdd'T'HHmmss'Z'"));
    return named.isValid()
               ? QLocale().toString(QDateTime(named.date(), named.time(), Qt::UTC).toLocalTime().time(),
                                    QStringLiteral("HH:mm:ss"))
               : QString();
}

} // namespace

QString displayName(const SourceRequest& request) {
    if (const auto* recording = std::get_if<RecordingRequest>(&request);
        recording && !recording->source.empty()) {
        const QString file = QFileInfo(QString::fromStdString(recording->path)).completeBaseName();
        const QString source = QString::fromStdString(recording->source);
        // A file that the program named begins with the time, and repeats what was recorded.
        const QString time = localTimeOf(file);
        return time.isEmpty() ? QStringLiteral("%1 (%2)").arg(file, source)
                              : QStringLiteral("%1 (%2)").arg(source, time);
    }
    if (const auto* remote = std::get_if<SiteRequest>(&request))
        return QStringLiteral("%1 (%2)").arg(QString::fromStdString(remote->device),
                                             QString::fromStdString(remote->name));
    const QString link = linkOf(request);
    return link.isEmpty() ? QFileInfo(pathOf(request)).completeBaseName() : link;
}

QString fileName(const SourceRequest& request) {
    const QString link = linkOf(request);
    return link.isEmpty() ? QFileInfo(pathOf(request)).fileName() : link;
}

pipeline::SourceFactory makeSourceFactory(SourceRequest request, const core::StopSwitch& stop,
                                          std::function<bool()> cancelled) {
    std::shared_ptr<site_link::SiteClient> site;
    if (const auto* remote = std::get_if<SiteRequest>(&request))
        site = remote->site.lock();
    return [request = std::move(request), &stop, cancelled = std::move(cancelled),
            site = std::move(site)]() -> core::Expected<Opened> {
        if (const auto* csv = std::get_if<CsvRequest>(&request))
            return openCsv(*csv);
        if (const auto* connected = std::get_if<WtsRequest>(&request))
            return openWts(*connected);
        if (const auto* camera = std::get_if<CameraRequest>(&request))
            return openCamera(*camera, stop);
        if (const auto* recording = std::get_if<RecordingRequest>(&request))
            return openRecording(*recording, stop);
        if (const auto* arm = std::get_if<ArmRequest>(&request))
            return openArm(*arm, stop, cancelled);
        if (const auto* remote = std::get_if<SiteRequest>(&request))
            return openRemote(site, *remote);
        if (const auto* described = std::get_if<TaxelsRequest>(&request))
            return openTaxels(*described, cancelled);
        if (const auto* gel = std::get_if<GelRequest>(&request))
            return openGel(*gel);
        if (const auto* camera = std::get_if<SceneCameraRequest>(&request))
            return openSceneCamera(*camera);
        return openScene(std::get<SceneRequest>(request), stop);
    };
}

core::Expected<CsvRequest> guessCsv(const std::string& path) {
    TELETA_TRY(const auto taxels, core::FrameFile::countTaxels(path));
    CsvRequest request;
    request.path = path;
    core::ArrayGuess guess = core::guessArray(taxels);
    request.layout = guess.layout;
    request.loadUnit = std::move(guess.unit);
    request.tarePath = core::unloadedBeside(path);
    return request;
}

} // namespace teleta::app
