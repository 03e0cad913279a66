// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/live_probing.h"

#include "backend/core/steady_time.h"
#include "backend/core/threads/wakeup.h"
#include "backend/vision/contacts/probe_watcher.h"
#include "backend/vision/finders/picture_view.h"

#include <chrono>
#include <utility>

namespace teleta::console {

namespace {

constexpr std::chrono::milliseconds kPatience{100};

} // namespace

struct LiveProbing::Run {
    ProbingThread::Run id;
    Opener opener;
    vision::CylinderSurface surface;
    std::uint64_t lifts = 0; ///< known to the watcher
    std::unique_ptr<core::CameraSource> source{};
    std::unique_ptr<vision::ProbeWatcher> watcher{};
    int width_px = 0;
    int height_px = 0;
    double last_s = 0.0;
    double offset_s = 0.0; ///< keeps the time increasing across connections
    QString why{};         ///< problem of the camera; empty: none
};

LiveProbing::LiveProbing(QObject* parent)
    : QObject(parent) {
    connect(&m_thread, &ProbingThread::runningChanged, this, &LiveProbing::runningChanged);
}

LiveProbing::~LiveProbing() = default;

void LiveProbing::start(Opener opener, const vision::CylinderSurface& surface) {
    m_referenceWanted = false;
    m_thread.start(
        [this, opener = std::move(opener), surface, lifts = m_lifts.load()](const ProbingThread::Run& id) {
            Run one{id, opener, surface, lifts};
            run(one);
        });
}

void LiveProbing::finish(const Run& run, const QString& why) {
    m_thread.tell(run.id, [this, why] {
        m_thread.ended();
        if (why.isEmpty())
            emit ended();
        else
            emit failed(why);
    });
}

void LiveProbing::tellTrouble(Run& run, const QString& why) {
    if (run.why == why)
        return;
    run.why = why;
    m_thread.tell(run.id, [this, why] { emit trouble(why); });
}

void LiveProbing::run(Run& run) {
    if (run.id.stop.stop_requested())
        return;
    auto source = run.opener();
    if (!source)
        return finish(run, QString::fromStdString(core::describe(source.error())));
    run.source = std::move(*source);
    core::Wakeup wakeup;
    run.source->start(wakeup);
    std::int64_t newest_ns = core::steadyNow_ns();
    while (!run.id.stop.stop_requested()) {
        // Read before the queue: then the queue holds every frame before the end of a video.
        const core::DeviceStatus status = run.source->status();
        core::CameraFrame frame;
        bool any = false;
        while (!run.id.stop.stop_requested() && run.source->pop(frame)) {
            any = true;
            if (!process(run, frame)) {
                run.source->stop();
                return;
            }
        }
        if (any) {
            newest_ns = core::steadyNow_ns();
            tellTrouble(run, {});
            continue;
        }
        if (status.state == core::DeviceState::finished) {
            run.source->stop();
            return finish(run, {});
        }
        if (status.state == core::DeviceState::lost || status.state == core::DeviceState::reconnecting)
            tellTrouble(run, QString::fromStdString(status.message));
        else if (core::steadyNow_ns() - newest_ns > kSilence_ns)
            tellTrouble(run, tr("The camera is open but sends no frames."));
        if (!run.why.isEmpty() && run.watcher)
            run.watcher->skip();
        wakeup.waitFor(kPatience);
    }
    run.source->stop();
}

bool LiveProbing::makeWatcher(Run& run, const core::GreyImage& image) {
    const vision::CalibrationSettings settings{image.width_px, image.height_px, run.surface};
    auto made = vision::ProbeWatcher::make(settings, run.id.stop);
    if (!made) {
        finish(run, QString::fromStdString(core::describe(made.error())));
        return false;
    }
    run.watcher = std::move(*made);
    run.width_px = image.width_px;
    run.height_px = image.height_px;
    m_thread.tell(run.id, [this, settings] { emit begun(settings); });
    return true;
}

bool LiveProbing::process(Run& run, const core::CameraFrame& frame) {
    if (frame.image.isEmpty()) {
        if (run.watcher)
            run.watcher->skip();
        return true;
    }
    if (!run.watcher && !makeWatcher(run, frame.image))
        return run.id.stop.stop_requested();
    if (frame.image.width_px != run.width_px || frame.image.height_px != run.height_px) {
        finish(run, tr("The camera's image size has changed from %1 \u00d7 %2 to %3 \u00d7 %4 pixels. Start "
                       "probing again.")
                        .arg(run.width_px)
                        .arg(run.height_px)
                        .arg(frame.image.width_px)
                        .arg(frame.image.height_px));
        return false;
    }
    if (frame.discontinuity) {
        run.watcher->skip();
        run.offset_s = run.last_s + 1.0 - frame.capture_s;
    }
    run.last_s = frame.capture_s + run.offset_s;
    const cv::Mat1b image = vision::viewOf(frame.image);
    if (const std::uint64_t lifts = m_lifts.load();
        std::exchange(run.lifts, lifts) != lifts && run.watcher->hasReference())
        run.watcher->awaitLift();
    std::optional<Eigen::Vector2d> pixel;
    if (!run.watcher->hasReference() || m_referenceWanted.exchange(false))
        static_cast<void>(
            run.watcher->setReference(image)); // a failure is shown, and the next frame is tried
    else
        pixel = run.watcher->next(image, run.last_s);
    show(run, frame);
    if (pixel)
        m_thread.tell(run.id, [this, at = *pixel, lifts = run.lifts] {
            if (lifts == m_lifts.load())
                emit touched(at);
        });
    return true;
}

void LiveProbing::show(const Run& run, const core::CameraFrame& frame) {
    ProbingView view;
    view.snapshot.image = view.snapshot.preview = frame.image;
    view.snapshot.time_ns = frame.time_ns;
    view.snapshot.time_s = run.last_s;
    view.snapshot.frame = frame.number;
    view.snapshot.surface = run.surface;
    view.snapshot.hasReference = run.watcher->hasReference();
    view.snapshot.problem = run.watcher->problem();
    view.snapshot.usable = view.snapshot.problem.empty();
    for (const vision::CameraContact& contact : run.watcher->contacts()) {
        vision::FollowedContact followed;
        followed.contact = contact;
        followed.contact.id = static_cast<int>(view.snapshot.contacts.size()) + 1;
        followed.contact.located = false; // the camera is not calibrated yet
        followed.seen = true;
        view.snapshot.contacts.push_back(std::move(followed));
    }
    view.phase = run.watcher->phase();
    view.progress = run.watcher->progress();
    view.recorded = run.source->description().recorded;
    m_views.post(std::move(view));
    if (m_viewTold.exchange(true))
        return;
    QMetaObject::invokeMethod(
        this,
        [this, id = run.id] {
            m_viewTold = false;
            const auto newest = m_views.take();
            if (newest && m_thread.isPresent(id))
                emit seen(*newest);
        },
        Qt::QueuedConnection);
}

} // namespace teleta::console
