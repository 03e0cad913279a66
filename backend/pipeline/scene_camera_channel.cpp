// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/scene_camera_channel.h"

#include "backend/pipeline/recorded/recorded_scene_camera.h"
#include "backend/recording/recorder.h"

#include <algorithm>
#include <utility>

namespace teleta::pipeline {

namespace {

/// Frames in one call, so that a source which is faster than this thread holds up no other.
constexpr std::size_t kMostFrames = 64;

} // namespace

SceneCameraChannel::SceneCameraChannel(std::unique_ptr<core::CameraSource> source)
    : m_source(std::move(source)) {
}

SceneCameraChannel::~SceneCameraChannel() {
    m_source->stop();
}

ChannelSummary SceneCameraChannel::summary() const {
    const core::CameraDescription& camera = description();
    return {camera.name, camera.nominalRate_Hz, camera.simulated, camera.recorded};
}

void SceneCameraChannel::record(const std::shared_ptr<recording::Recorder>& recorder,
                                const std::string& name) {
    m_tap.set(tapInto(recorder.get(), name));
}

void SceneCameraChannel::watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
                               const std::string& name) {
    m_watched[static_cast<std::size_t>(who)].set(tapInto(sink.get(), name));
}

SceneCameraChannel::Tap SceneCameraChannel::tapInto(recording::StreamSink* sink,
                                                    const std::string& name) const {
    return sink != nullptr ? sink->addStream(sceneCameraStream(name + "-scene", description())) : nullptr;
}

std::size_t SceneCameraChannel::process() {
    std::array<Tap, 1 + kWatchers> taps{m_tap.get()};
    std::ranges::transform(m_watched, taps.begin() + 1, [](const auto& watched) { return watched.get(); });
    core::CameraFrame frame;
    std::size_t frames = 0;
    while (frames < kMostFrames && m_source->pop(frame)) {
        ++frames;
        core::ColourImage image = core::colourOf(frame.image);
        if (image.isEmpty()) {
            ++m_newest.undecodable;
            continue;
        }
        for (const Tap& tap : taps)
            if (tap)
                tap->append(frame);
        m_newest.image = std::move(image);
        m_newest.time_ns = frame.time_ns;
        m_newest.capture_s = frame.capture_s;
        m_newest.frame = frame.number;
        ++m_newest.pictures;
    }
    if (frames == 0)
        return 0;
    m_processed.fetch_add(frames, std::memory_order_relaxed);
    m_snapshots.back() = m_newest;
    m_snapshots.publish();
    return frames;
}

} // namespace teleta::pipeline
