// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_sources.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace teleta::pipeline {

namespace {

struct RecordedSourcesText {
    Q_DECLARE_TR_FUNCTIONS(RecordedStreams)
};

using recording::Recording;
using recording::StreamInfo;
using recording::StreamKind;

constexpr std::string_view kFrames = "-frames";
constexpr std::string_view kTemperatures = "-temperatures";
constexpr std::string_view kJoints = "-joints";
constexpr std::string_view kWrench = "-wrench";

/// The stream of numbers of this kind and name that has frames. columns: what a frame has; 0: any number.
core::Expected<std::optional<std::size_t>> findFrames(const Recording& recording, StreamKind kind,
                                                      const std::string& name, std::size_t columns) {
    const std::vector<StreamInfo>& streams = recording.streams();
    for (std::size_t i = 0; i < streams.size(); ++i) {
        const std::size_t found = streams[i].columns.size();
        if (streams[i].kind != kind || streams[i].name != name || found == 0 ||
            found != streams[i].channels() || (columns > 0 && found != columns) ||
            streams[i].type != recording::ValueType::float64)
            continue;
        TELETA_TRY(const auto extent, recording.extent(i));
        return extent ? std::optional(i) : std::nullopt;
    }
    return std::nullopt;
}

/// What belongs to the same device as a stream that is called NAMEend; empty: it is not called so.
std::string besideIt(const std::string& stream, std::string_view end, std::string_view other) {
    if (!stream.ends_with(end))
        return {};
    return stream.substr(0, stream.size() - end.size()) + std::string(other);
}

/// why: the first thing that is not described.
core::Expected<std::vector<RecordedSource>> recordedArrays(const Recording& recording,
                                                           std::optional<core::Error>& why) {
    std::vector<RecordedSource> sources;
    const std::vector<StreamInfo>& streams = recording.streams();
    for (std::size_t i = 0; i < streams.size(); ++i) {
        if (streams[i].kind != StreamKind::array)
            continue;
        TELETA_TRY(const auto extent, recording.extent(i));
        if (!extent)
            continue;
        TELETA_TRY(const auto temperatures, findFrames(recording, StreamKind::numbers,
                                                       besideIt(streams[i].name, kFrames, kTemperatures), 0));
        const std::size_t chips = temperatures ? streams[*temperatures].columns.size() : 0;
        auto array = recordedArray(streams[i], recording.path(), chips);
        if (!array) {
            why = why.value_or(array.error());
            continue;
        }
        sources.push_back({.arrayStream = i,
                           .array = std::move(*array),
                           .jointStream = {},
                           .wrenchStream = {},
                           .temperatureStream = temperatures,
                           .chips = chips,
                           .arm = {},
                           .chain = {}});
    }
    return sources;
}

/// Gives each arm to the array that it wears; one that was recorded without a skin is a source of its own.
/// One whose skin cannot be played is left out, but for an arm with a pad, which can be shown without it.
core::Expected<void> addArms(const Recording& recording, RecordedSources& sources,
                             std::optional<core::Error>& why) {
    const std::vector<StreamInfo>& streams = recording.streams();
    for (std::size_t i = 0; i < streams.size(); ++i) {
        if (streams[i].kind != StreamKind::joints)
            continue;
        auto arm = recordedArm(streams[i], recording.path());
        if (!arm) {
            why = why.value_or(arm.error());
            continue;
        }
        TELETA_TRY(const auto wrench, findFrames(recording, StreamKind::wrench,
                                                 besideIt(streams[i].name, kJoints, kWrench), kWrenchValues));
        const auto skin = std::ranges::find_if(sources.arrays, [&](const RecordedSource& source) {
            return streams[source.arrayStream].name == arm->skinStream;
        });
        if (skin != sources.arrays.end()) {
            skin->jointStream = i;
            skin->wrenchStream = wrench;
            skin->arm = std::move(arm->description);
            skin->chain = std::move(arm->chain);
        } else if (arm->skinStream.empty() || arm->description.pad) {
            TELETA_TRY(const auto extent, recording.extent(i));
            if (extent)
                sources.arms.push_back({i, wrench, std::move(arm->description), std::move(arm->chain)});
        }
    }
    return {};
}

} // namespace

core::Expected<RecordedSources> recordedSources(const Recording& recording) {
    std::optional<core::Error> why;
    RecordedSources sources{.arrays = {},
                            .arms = {},
                            .cameras = {},
                            .gels = {},
                            .sceneCameras = {},
                            .first_ns = std::numeric_limits<std::int64_t>::max(),
                            .last_ns = std::numeric_limits<std::int64_t>::min()};
    TELETA_TRY(sources.arrays, recordedArrays(recording, why));
    TELETA_CHECK(addArms(recording, sources, why));
    TELETA_TRY(sources.cameras, recordedCameras(recording, why));
    TELETA_TRY(sources.gels, recordedGels(recording, why));
    TELETA_TRY(sources.sceneCameras, recordedSceneCameras(recording, why));
    const bool isEmpty = sources.arrays.empty() && sources.arms.empty() && sources.cameras.empty() &&
                         sources.gels.empty() && sources.sceneCameras.empty();
    if (isEmpty && why)
        return core::Unexpected(*why);
    if (isEmpty)
        return core::failed(
            core::ErrorKind::refused,
            RecordedSourcesText::tr("the recording has no frames of an array, an arm or a camera"),
            RecordedSourcesText::tr("a recording of an array, an arm or a camera"), {recording.path()});
    const auto include = [&](std::size_t stream) {
        if (const auto extent = recording.extent(stream); extent && *extent) {
            sources.first_ns = std::min(sources.first_ns, (*extent)->first_ns);
            sources.last_ns = std::max(sources.last_ns, (*extent)->last_ns);
        }
    };
    for (const RecordedSource& source : sources.arrays)
        include(source.arrayStream);
    for (const RecordedJoints& arm : sources.arms)
        include(arm.stream);
    for (const RecordedCamera& camera : sources.cameras)
        include(camera.stream);
    for (const RecordedGel& gel : sources.gels)
        include(gel.stream);
    for (const RecordedSceneCamera& camera : sources.sceneCameras)
        include(camera.stream);
    return sources;
}

} // namespace teleta::pipeline
