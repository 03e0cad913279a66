// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/recording_request.h"

#include "backend/core/failure.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/pipeline/gel_channel.h"
#include "backend/pipeline/joint_channel.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/pipeline/scene_camera_channel.h"
#include "backend/pipeline/touch_channel.h"
#include "devices/replay/recorded_device.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

namespace teleta::app {

namespace {

struct PlaybackText {
    Q_DECLARE_TR_FUNCTIONS(RecordingRequest)
};

using Opened = std::shared_ptr<pipeline::Channel>;

constexpr std::array<const char*, 6> kFrameFiles{".npz", ".npy", ".h5", ".hdf5", ".mat", ".asf"};

core::Expected<Opened> openArray(replay::RecordedConfig config, pipeline::RecordedSource source) {
    config.stream = source.arrayStream;
    config.array = std::move(source.array.description);
    config.jointStream = source.jointStream;
    config.wrenchStream = source.wrenchStream;
    config.temperatureStream = source.temperatureStream;
    config.chips = source.chips;
    config.arm = std::move(source.arm);
    TELETA_TRY(auto player, replay::RecordedPlayer::open(std::move(config)));
    auto array = std::make_shared<pipeline::TouchChannel>(std::make_unique<replay::RecordedArray>(player),
                                                          std::move(source.array.settings));
    array->setLoads(std::move(source.array.loads));
    if (!source.jointStream)
        return array;
    if (const auto pad = player->config().arm.pad) {
        TELETA_TRY(auto arm, pipeline::ArmChannel::withPad(std::make_unique<replay::RecordedArm>(player),
                                                           std::move(array), std::move(source.chain), *pad));
        return Opened(std::move(arm));
    }
    return std::make_shared<pipeline::ArmChannel>(std::make_unique<replay::RecordedArm>(player),
                                                  std::move(array));
}

core::Expected<Opened> openJoints(replay::RecordedConfig config, const pipeline::RecordedJoints& source) {
    config.stream = source.stream;
    config.arm = source.arm;
    config.wrenchStream = source.wrenchStream;
    config.jointsAlone = true;
    TELETA_TRY(auto player, replay::RecordedPlayer::open(std::move(config)));
    return std::make_shared<pipeline::JointChannel>(
        std::make_unique<replay::RecordedJoints>(std::move(player)), source.chain);
}

core::Expected<Opened> openCamera(replay::RecordedConfig config, const recording::Recording& recording,
                                  const pipeline::RecordedCamera& source, const core::StopSwitch& stop) {
    auto reference = pipeline::firstReference(recording, source.referenceStream);
    TELETA_CHECK(reference);
    config.stream = source.stream;
    config.camera = source.description;
    config.referenceStream = source.referenceStream;
    TELETA_TRY(auto player, replay::RecordedPlayer::open(std::move(config)));
    pipeline::CameraChannel::Settings settings;
    settings.tracker.bump = source.bump;
    settings.reference = std::move(*reference);
    auto channel = pipeline::CameraChannel::make(std::make_unique<replay::RecordedCamera>(player),
                                                 source.camera, stop, nullptr, settings);
    TELETA_CHECK(channel);
    return *channel;
}

core::Expected<Opened> openGel(replay::RecordedConfig config, const recording::Recording& recording,
                               const pipeline::RecordedGel& source) {
    TELETA_TRY(auto reference, pipeline::firstReference(recording, source.referenceStream));
    config.stream = source.stream;
    config.camera = source.description;
    config.referenceStream = source.referenceStream;
    TELETA_TRY(auto player, replay::RecordedPlayer::open(std::move(config)));
    auto channel = std::make_shared<pipeline::GelChannel>(std::make_unique<replay::RecordedCamera>(player),
                                                          source.file, std::move(reference));
    channel->setLoads(source.loads);
    return channel;
}

core::Expected<Opened> openSceneCamera(replay::RecordedConfig config,
                                       const pipeline::RecordedSceneCamera& source) {
    config.stream = source.stream;
    config.camera = source.description;
    TELETA_TRY(auto player, replay::RecordedPlayer::open(std::move(config)));
    return std::make_shared<pipeline::SceneCameraChannel>(std::make_unique<replay::RecordedCamera>(player));
}

} // namespace

bool isRecordingName(const QString& path) {
    return path.endsWith(QLatin1String(".teleta"), Qt::CaseInsensitive);
}

bool isMcapName(const QString& path) {
    return path.endsWith(QLatin1String(".mcap"), Qt::CaseInsensitive);
}

bool isFrameFileName(const QString& path) {
    return std::ranges::any_of(kFrameFiles, [&](const char* suffix) {
        return path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
    });
}

bool isImported(const QString& path) {
    return isMcapName(path) || isFrameFileName(path);
}

bool isPlayable(const QString& path) {
    return isRecordingName(path) || isImported(path) ||
           path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive);
}

core::Expected<std::vector<RecordingRequest>> recordingRequestsOf(const std::string& path) {
    TELETA_TRY(const auto recording, recording::Recording::open(path));
    TELETA_TRY(const auto sources, pipeline::recordedSources(recording));
    std::vector<RecordingRequest> requests;
    for (const pipeline::RecordedSceneCamera& camera : sources.sceneCameras)
        requests.push_back({path, recording.streams()[camera.stream].name, camera.description.name, false});
    for (const pipeline::RecordedCamera& camera : sources.cameras)
        requests.push_back({path, recording.streams()[camera.stream].name, camera.description.name, false});
    for (const pipeline::RecordedGel& gel : sources.gels)
        requests.push_back({path, recording.streams()[gel.stream].name, gel.description.name, false});
    for (const pipeline::RecordedJoints& arm : sources.arms)
        requests.push_back({path, recording.streams()[arm.stream].name, arm.arm.name, false});
    // The first array last: what is opened last is shown.
    for (auto array = sources.arrays.rbegin(); array != sources.arrays.rend(); ++array) {
        const std::string& stream = recording.streams()[array->arrayStream].name;
        requests.push_back({path, stream, array->array.description.name, false,
                            pipeline::settingsChanged(recording.events(), stream)});
    }
    return requests;
}

core::Expected<std::shared_ptr<pipeline::Channel>> openRecording(const RecordingRequest& request,
                                                                 const core::StopSwitch& stop) {
    TELETA_TRY(const auto recording, recording::Recording::open(request.path));
    TELETA_TRY(auto sources, pipeline::recordedSources(recording));
    replay::RecordedConfig config;
    config.path = request.path;
    config.loop = request.loop;
    config.autoplay = false;
    config.span = replay::RecordedConfig::Span{sources.first_ns, sources.last_ns};
    const auto isIt = [&](std::size_t stream) { return recording.streams()[stream].name == request.stream; };
    for (pipeline::RecordedSource& source : sources.arrays)
        if (isIt(source.arrayStream))
            return openArray(std::move(config), std::move(source));
    for (const pipeline::RecordedJoints& source : sources.arms)
        if (isIt(source.stream))
            return openJoints(std::move(config), source);
    for (const pipeline::RecordedCamera& source : sources.cameras)
        if (isIt(source.stream))
            return openCamera(std::move(config), recording, source, stop);
    for (const pipeline::RecordedGel& source : sources.gels)
        if (isIt(source.stream))
            return openGel(std::move(config), recording, source);
    for (const pipeline::RecordedSceneCamera& source : sources.sceneCameras)
        if (isIt(source.stream))
            return openSceneCamera(std::move(config), source);
    return core::failed(core::ErrorKind::refused,
                        PlaybackText::tr("the recording has no stream \"%1\" to play")
                            .arg(QString::fromStdString(request.stream)),
                        {}, {request.path});
}

} // namespace teleta::app
