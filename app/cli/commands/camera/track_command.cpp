// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/camera/track_command.h"

#include "app/cli/base/interruption.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/tracker_losses.h"
#include "backend/vision/calibration/camera_file.h"
#include "backend/vision/contacts/camera_tracker.h"
#include "backend/vision/contacts/contact_rows.h"
#include "backend/vision/finders/contact_ladder.h"
#include "devices/camera/video_stream.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace teleta::cli {

namespace {

using Outcome = camera::VideoStream::Outcome;

struct TrackText {
    Q_DECLARE_TR_FUNCTIONS(TrackCommand)
};

} // namespace

QString TrackCommand::summary() const {
    return TrackText::tr("Find contacts on the soft tube in a video or live from a camera");
}

const char* TrackCommand::example() const {
    return "teleta track press.avi --camera camera.json --out contacts.csv";
}

void TrackCommand::declare(CLI::App& app) {
    const auto help = [](const char* text) { return TrackText::tr(text).toStdString(); };
    app.add_option("video", m_video,
                   help(QT_TRANSLATE_NOOP("TrackCommand",
                                          "Video, pattern of numbered images (frame_%04d.png) or number of a "
                                          "camera; nothing touches the tube in the first frame")))
        ->type_name("VIDEO")
        ->required();
    app.add_option("--camera", m_cameraPath,
                   help(QT_TRANSLATE_NOOP("TrackCommand", "Camera file, as calibrate writes it")))
        ->type_name("CAMERA.json")
        ->required();
    std::vector<std::string> presets;
    for (const vision::ContactRung& rung : vision::contactLadder())
        presets.emplace_back(rung.name);
    m_preset = presets.front();
    app.add_option(
           "--preset", m_preset,
           help(QT_TRANSLATE_NOOP("TrackCommand", "How contacts are found; the more exact, the slower")))
        ->type_name("NAME")
        ->check(CLI::IsMember(presets))
        ->capture_default_str();
    declareJson(app, m_output.json);
    declareOut(app, m_output.outPath);
}

core::Expected<void> TrackCommand::run() {
    for (const std::string& input : {m_video, m_cameraPath}) {
        std::error_code missing;
        if (!m_output.outPath.empty() && std::filesystem::equivalent(input, m_output.outPath, missing))
            throw CLI::ValidationError("--out",
                                       TrackText::tr("the output would replace the input").toStdString());
    }
    TELETA_TRY(const vision::CameraFile file, vision::readCamera(m_cameraPath));
    TELETA_TRY(camera::VideoStream stream, camera::VideoStream::open(m_video));
    TELETA_TRY(auto finder, vision::makeContactFinder(*vision::contactRung(m_preset), file.camera));
    vision::CameraTracker tracker(std::move(finder), {});
    TELETA_TRY(RowOutput rows, RowOutput::open(vision::kContactColumns, m_output));

    ProgressBar progress(ProgressBar::Unit::simulatedSeconds, rows.onTerminal());
    const double duration_s =
        stream.rate_Hz() > 0.0 ? static_cast<double>(stream.framesTotal()) / stream.rate_Hz() : 0.0;
    cv::Mat1b image;
    Outcome outcome = Outcome::frame;
    bool stopped = false;
    for (long long frame = 0; !(stopped = interrupted()) && !rows.failed(); ++frame) {
        double time_s = 0.0;
        outcome = stream.next(image, time_s);
        if (outcome == Outcome::ended || outcome == Outcome::gone)
            break;
        if (outcome == Outcome::late)
            continue;
        const auto contacts = tracker.next(outcome == Outcome::frame ? image : cv::Mat1b(), time_s);
        if (!contacts && outcome == Outcome::frame) {
            core::Error error = contacts.error();
            error.where.file = m_video;
            return core::Unexpected(error);
        }
        if (!contacts)
            continue;
        const int bumped = tracker.bump() ? tracker.bump()->contact : 0;
        for (const vision::FollowedContact& followed : *contacts) {
            if (followed.seen || followed.event == vision::ContactEvent::ends)
                vision::writeContact(rows, frame, time_s, followed, bumped);
        }
        rows.flushIfDue();
        progress.update(time_s, duration_s);
    }
    progress.erase();
    TELETA_CHECK(rows.finish());
    warnOfUnusableFrames(tracker);
    if (stream.framesSkipped() > 0)
        warn(TrackText::tr("Frames missing according to their time stamps: %1").arg(stream.framesSkipped()));
    if (stopped)
        return core::Unexpected(interruption());
    const auto failed = [&](core::ErrorKind kind, const QString& message) {
        return core::Unexpected(core::Error{kind, message.toStdString(), {}, {m_video, 0, 0}});
    };
    if (outcome == Outcome::gone)
        return failed(core::ErrorKind::unavailable, TrackText::tr("the camera has stopped sending frames"));
    if (!tracker.hasReference())
        return failed(core::ErrorKind::badInput, TrackText::tr("the video has no frame that can be decoded"));
    return {};
}

} // namespace teleta::cli
