// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/scene_recording.h"

#include "backend/pipeline/recorded_streams.h"
#include "backend/recording/stream_columns.h"
#include "backend/scene_run/scene_settings.h"

#include <QCoreApplication>
#include <QFile>
#include <QString>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <thread>

namespace teleta::scene_run {

namespace {

constexpr char kSkin[] = "frames";
constexpr std::size_t kFramesAtOnce = 128;
/// So few that a slow disk does not fill the memory.
constexpr std::size_t kBlocksAtMost = 32;
constexpr std::chrono::milliseconds kWaitForWriter{5};
constexpr char kPart[] = ".part";

struct SceneRecordingText {
    Q_DECLARE_TR_FUNCTIONS(SceneRecording)
};

void removeLog(const std::string& path) {
    for (const char* suffix : {"-wal", "-shm"})
        QFile::remove(QString::fromStdString(path + suffix));
}

} // namespace

template <typename Number>
void SceneRecording::Batch<Number>::add(double at_s, std::span<const Number> frame) {
    if (!tap)
        return;
    time_ns.push_back(std::llround(at_s * 1e9));
    time_s.push_back(at_s);
    values.insert(values.end(), frame.begin(), frame.end());
    if (time_ns.size() == kFramesAtOnce)
        flush();
}

template <typename Number>
void SceneRecording::Batch<Number>::flush() {
    if (!tap || time_ns.empty())
        return;
    while (!tap->tryAppend(std::span<const std::int64_t>(time_ns), std::span<const double>(time_s),
                           std::span<const Number>(values)))
        std::this_thread::sleep_for(kWaitForWriter);
    time_ns.clear();
    time_s.clear();
    values.clear();
}

core::Expected<SceneRecording> SceneRecording::open(const RunOptions& options, const scene::Scene& scene) {
    SceneRecording log;
    if (options.outFolder.empty())
        return log;
    log.m_path = options.outFolder + "/recording.teleta";
    const std::string part = log.m_path + kPart;
    QFile::remove(QString::fromStdString(part));
    removeLog(part);
    const nlohmann::ordered_json configuration{{"seed", options.seed},
                                               {"duration_s", options.duration_s.value_or(scene.duration_s)}};
    auto recorder =
        recording::Recorder::start(part,
                                   {.appVersion = QCoreApplication::applicationVersion().toStdString(),
                                    .scene = options.name,
                                    .sceneText = options.sceneText,
                                    .configuration = configuration.dump(),
                                    .start_ns = 0},
                                   {.simulatedTime = true, .queueBlocks = kBlocksAtMost});
    if (!recorder)
        return core::Unexpected(recorder.error());
    log.m_recorder = std::move(*recorder);
    return log;
}

void SceneRecording::beginArray(const core::SourceDescription& description, const scene::Scene& scene) {
    if (m_recorder)
        m_frames.tap =
            m_recorder->addStream(pipeline::arrayStream(kSkin, description, channelSettings(scene)));
}

void SceneRecording::beginArm(const core::ArmDescription& description) {
    if (!m_recorder)
        return;
    m_joints.tap = m_recorder->addStream(pipeline::armStream("joints", description, kSkin));
    m_touches.tap = m_recorder->addStream(pipeline::touchStream("touches", description));
}

void SceneRecording::addFrame(double time_s, std::span<const float> values) {
    m_frames.add(time_s, values);
}

void SceneRecording::addJoints(const core::JointSample& sample) {
    const auto values = recording::jointValues(sample);
    m_joints.add(sample.sourceTime_s, std::span<const double>(values));
}

void SceneRecording::addTouch(const pipeline::TouchRecord& touch) {
    const auto values = pipeline::touchValues(touch);
    m_touches.add(touch.ready_s, std::span<const double>(values));
}

core::Expected<void> SceneRecording::finish() {
    if (!m_recorder)
        return {};
    m_frames.flush();
    m_joints.flush();
    m_touches.flush();
    if (const core::Expected<void> stopped = m_recorder->stop(); !stopped)
        return stopped;
    const std::string& part = m_recorder->path();
    // With a log it is whole under the name that the log has, too.
    std::error_code error;
    if (std::filesystem::exists(part + "-wal", error))
        return core::Unexpected(
            core::Error{core::ErrorKind::ioFailed,
                        SceneRecordingText::tr("another program reads the recording, which keeps this name")
                            .toStdString(),
                        {},
                        {part}});
    // Another one's log would be read as its own.
    removeLog(m_path);
    std::filesystem::rename(part, m_path, error);
    if (error)
        return core::Unexpected(core::Error{core::ErrorKind::ioFailed, error.message(), {}, {m_path}});
    return {};
}

} // namespace teleta::scene_run
