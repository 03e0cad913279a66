// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/tracker_rows.h"
#include "app/cli/commands/camera/camera_commands.h"
#include "backend/core/failure.h"
#include "backend/vision/calibration/camera_file.h"
#include "backend/vision/contacts/camera_tracker.h"
#include "backend/vision/contacts/contact_rows.h"
#include "backend/vision/finders/contact_ladder.h"
#include "devices/camera/video_stream.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>

#include <array>
#include <string>
#include <vector>

namespace teleta::cli {

namespace {

using Outcome = camera::VideoStream::Outcome;

struct TrackText {
    Q_DECLARE_TR_FUNCTIONS(TrackCommand)
};

class TrackCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "video", m_video,
                  TrackText::tr("Video, pattern of numbered images (frame_%04d.png) or number of a camera; "
                                "nothing touches the tube in the first frame"),
                  "VIDEO")
            ->required();
        addOption(app, "--camera", m_cameraPath, TrackText::tr("Camera file, as calibrate writes it"),
                  "CAMERA.json")
            ->required();
        std::vector<std::string> presets;
        for (const vision::ContactRung& rung : vision::contactLadder())
            presets.emplace_back(rung.name);
        m_preset = presets.front();
        addOption(app, "--preset", m_preset,
                  TrackText::tr("How contacts are found; the more exact, the slower"), CLI::IsMember(presets),
                  "NAME");
        declareJson(app, m_output.json);
        declareOut(app, m_output.outPath);
    }

    [[nodiscard]] core::Expected<void> run() {
        refuseToReplace(m_output.outPath, std::array{m_video, m_cameraPath});
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
            writeContacts(rows, frame, time_s, tracker, *contacts);
            rows.flushIfDue();
            progress.update(time_s, duration_s);
        }
        progress.erase();
        TELETA_CHECK(rows.finish());
        warnOfUnusableFrames(tracker);
        if (stream.framesSkipped() > 0)
            warn(TrackText::tr("Frames missing according to their time stamps: %1")
                     .arg(stream.framesSkipped()));
        if (stopped)
            return core::Unexpected(interruption());
        if (outcome == Outcome::gone)
            return core::failed(core::ErrorKind::unavailable,
                                TrackText::tr("the camera has stopped sending frames"), {}, {m_video});
        if (!tracker.hasReference())
            return core::failed(core::ErrorKind::badInput,
                                TrackText::tr("the video has no frame that can be decoded"), {}, {m_video});
        return {};
    }

private:
    std::string m_video;
    std::string m_cameraPath;
    std::string m_preset;
    RowOptions m_output;
};

} // namespace

Command trackCommand() {
    return makeCommand<TrackCommand>(
        "track", TrackText::tr("Find contacts on the soft tube in a video or live from a camera"),
        "teleta track press.avi --camera camera.json --out contacts.csv");
}

} // namespace teleta::cli
