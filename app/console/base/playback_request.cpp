// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/base/playback_request.h"

#include "backend/pipeline/camera_channel.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "devices/replay/recorded_device.h"

#include <QCoreApplication>

#include <memory>
#include <utility>

namespace teleta::console {

namespace {

struct PlaybackText {
    Q_DECLARE_TR_FUNCTIONS(PlaybackRequest)
};

core::Expected<pipeline::OpenedSource> openArray(replay::RecordedConfig config,
                                                 pipeline::RecordedSource source) {
    config.stream = source.arrayStream;
    config.array = std::move(source.array.description);
    config.jointStream = source.jointStream;
    config.arm = std::move(source.arm);
    auto player = replay::RecordedPlayer::open(std::move(config));
    if (!player)
        return core::Unexpected(player.error());
    pipeline::OpenedSource opened{std::make_unique<replay::RecordedArray>(*player),
                                  std::move(source.array.settings)};
    if (source.jointStream)
        opened.arm = std::make_unique<replay::RecordedArm>(*player);
    return opened;
}

core::Expected<pipeline::OpenedSource> openCamera(replay::RecordedConfig config,
                                                  const recording::Recording& recording,
                                                  const pipeline::RecordedCamera& source,
                                                  const core::StopSwitch& stop) {
    auto reference = pipeline::firstReference(recording, source);
    if (!reference)
        return core::Unexpected(reference.error());
    config.stream = source.stream;
    config.camera = source.description;
    config.referenceStream = source.referenceStream;
    auto player = replay::RecordedPlayer::open(std::move(config));
    if (!player)
        return core::Unexpected(player.error());
    pipeline::CameraChannel::Settings settings;
    settings.tracker.bump = source.bump;
    settings.reference = std::move(*reference);
    auto channel = pipeline::CameraChannel::make(std::make_unique<replay::RecordedCamera>(*player),
                                                 source.camera, stop, nullptr, settings);
    if (!channel)
        return core::Unexpected(channel.error());
    pipeline::OpenedSource opened;
    opened.camera = std::move(*channel);
    return opened;
}

} // namespace

bool isRecordingName(const QString& path) {
    return path.endsWith(QLatin1String(".teleta"), Qt::CaseInsensitive);
}

core::Expected<std::vector<PlaybackRequest>> playbacksOf(const std::string& path) {
    const auto recording = recording::Recording::open(path);
    if (!recording)
        return core::Unexpected(recording.error());
    const auto sources = pipeline::recordedSources(*recording);
    if (!sources)
        return core::Unexpected(sources.error());
    std::vector<PlaybackRequest> requests;
    for (const pipeline::RecordedCamera& camera : sources->cameras)
        requests.push_back({path, recording->streams()[camera.stream].name, camera.description.name, false});
    // The first array last: what is opened last is shown.
    for (auto array = sources->arrays.rbegin(); array != sources->arrays.rend(); ++array) {
        const std::string& stream = recording->streams()[array->arrayStream].name;
        requests.push_back({path, stream, array->array.description.name, false,
                            pipeline::settingsChanged(recording->events(), stream)});
    }
    return requests;
}

core::Expected<pipeline::OpenedSource> openPlayback(const PlaybackRequest& request,
                                                    const core::StopSwitch& stop) {
    const auto recording = recording::Recording::open(request.path);
    if (!recording)
        return core::Unexpected(recording.error());
    auto sources = pipeline::recordedSources(*recording);
    if (!sources)
        return core::Unexpected(sources.error());
    replay::RecordedConfig config;
    config.path = request.path;
    config.loop = request.loop;
    config.autoplay = false;
    config.span = replay::RecordedConfig::Span{sources->first_ns, sources->last_ns};
    const auto isIt = [&](std::size_t stream) { return recording->streams()[stream].name == request.stream; };
    for (pipeline::RecordedSource& source : sources->arrays)
        if (isIt(source.arrayStream))
            return openArray(std::move(config), std::move(source));
    for (const pipeline::RecordedCamera& source : sources->cameras)
        if (isIt(source.stream))
            return openCamera(std::move(config), *recording, source, stop);
    return core::Unexpected(core::Error{core::ErrorKind::refused,
                                        PlaybackText::tr("the recording has no stream \"%1\" to play")
                                            .arg(QString::fromStdString(request.stream))
                                            .toStdString(),
                                        {},
                                        {request.path}});
}

} // namespace teleta::console
