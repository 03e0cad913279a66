// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/base/scene_recording.h"

#include "backend/core/failure.h"
#include "backend/pipeline/recorded/recorded_camera.h"
#include "backend/pipeline/recorded/recorded_gel.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/stream_columns.h"
#include "backend/scene_run/base/scene_settings.h"

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
    TELETA_TRY(log.m_recorder,
               recording::Recorder::start(part,
                                          {.appVersion = QCoreApplication::applicationVersion().toStdString(),
                                           .scene = options.name,
                                           .sceneText = options.sceneText,
                                           .configuration = configuration.dump(),
                                           .start_ns = 0},
                                          {.simulatedTime = true, .queueBlocks = kBlocksAtMost}));
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

void SceneRecording::beginCamera(const core::CameraDescription& description,
                                 const vision::CylinderCamera& camera,
                                 const vision::BumpDetector::Settings& bump,
                                 const core::GreyImage& untouched) {
    if (!m_recorder)
        return;
    constexpr char kReference[] = "reference";
    // A stream of its own: it is no moment of the scene.
    const auto reference = m_recorder->addStream(pipeline::referenceStream(kReference, description));
    append(*reference, 0.0, untouched);
    m_pictures =
        m_recorder->addStream(pipeline::cameraStream("camera", description, camera, bump, kReference));
    m_contacts.tap = m_recorder->addStream(pipeline::contactStream("contacts", description));
}

void SceneRecording::beginGel(const core::CameraDescription& description, const vision::MarkerGelFile& file) {
    if (!m_recorder)
        return;
    constexpr char kReference[] = "reference";
    m_gelReference = m_recorder->addStream(pipeline::referenceStream(kReference, description));
    m_pictures = m_recorder->addStream(pipeline::gelStream("camera", description, file, kReference));
    m_contacts.tap = m_recorder->addStream(pipeline::gelContactStream("contacts", description));
}

void SceneRecording::append(core::StreamTap& tap, double time_s, const core::GreyImage& picture) {
    while (!tap.tryAppend({.image = picture, .time_ns = std::llround(time_s * 1e9), .capture_s = time_s}))
        std::this_thread::sleep_for(kWaitForWriter);
}

void SceneRecording::addPicture(double time_s, const core::GreyImage& picture) {
    if (m_pictures)
        append(*m_pictures, time_s, picture);
}

void SceneRecording::addContact(double time_s, const vision::FollowedContact& followed) {
    m_contacts.add(time_s, pipeline::contactValues(followed));
}

void SceneRecording::addGelReference(const std::vector<cv::Mat1b>& pictures) {
    if (!m_gelReference)
        return;
    std::vector<core::GreyImage> images;
    for (const cv::Mat1b& picture : pictures)
        images.push_back(core::greyImageOf(picture));
    append(*m_gelReference, 0.0, pipeline::stackedReference(images));
}

void SceneRecording::addGelContact(double time_s, const vision::GelContactState& contact) {
    m_contacts.add(time_s, pipeline::gelContactValues(contact));
}

void SceneRecording::addFrame(double time_s, std::span<const float> values) {
    m_frames.add(time_s, values);
}

void SceneRecording::addJoints(const core::JointSample& sample) {
    m_joints.add(sample.sourceTime_s, recording::jointValues(sample, sample.angle_rad.size()));
}

void SceneRecording::addTouch(const pipeline::TouchRecord& touch) {
    m_touches.add(touch.ready_s, pipeline::touchValues(touch));
}

core::Expected<void> SceneRecording::finish() {
    if (!m_recorder)
        return {};
    m_frames.flush();
    m_joints.flush();
    m_touches.flush();
    m_contacts.flush();
    TELETA_CHECK(m_recorder->stop());
    const std::string& part = m_recorder->path();
    // With a log it is whole under the name that the log has, too.
    std::error_code error;
    if (std::filesystem::exists(part + "-wal", error))
        return core::failed(
            core::ErrorKind::ioFailed,
            SceneRecordingText::tr("another program reads the recording, which keeps this name"), {}, {part});
    // Another one's log would be read as its own.
    removeLog(m_path);
    std::filesystem::rename(part, m_path, error);
    if (error)
        return core::failed(core::ErrorKind::ioFailed, QString::fromStdString(error.message()), {}, {m_path});
    return {};
}

} // namespace teleta::scene_run
