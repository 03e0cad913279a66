// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/camera_channel.h"

#include "backend/core/elapsed.h"
#include "backend/core/steady_time.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::pipeline {

namespace {

constexpr double kLeastPeriod_s = 0.025;

using vision::ContactEvent;
using vision::FollowedContact;

/// The pixels themselves, which nobody writes to.
cv::Mat1b viewOf(const core::GreyImage& image) {
    if (image.isEmpty())
        return {};
    return {image.height_px, image.width_px, const_cast<std::uint8_t*>(image.pixels.get())};
}

core::GreyImage previewOf(const core::GreyImage& image) {
    const cv::Mat1b whole = viewOf(image);
    if (whole.empty() || whole.cols <= CameraChannel::kPreview_px)
        return image;
    const double scale = static_cast<double>(CameraChannel::kPreview_px) / whole.cols;
    cv::Mat1b small;
    cv::resize(whole, small, {}, scale, scale, cv::INTER_AREA);
    return core::greyImageOf(std::move(small));
}

} // namespace

core::Expected<std::shared_ptr<CameraChannel>> CameraChannel::make(std::unique_ptr<core::CameraSource> source,
                                                                   const vision::CylinderCamera& camera,
                                                                   const core::StopSwitch& stop,
                                                                   std::unique_ptr<CameraReaction> reaction,
                                                                   const Settings& settings) {
    auto finder = vision::makeContactFinder(vision::contactLadder().front(), camera, settings.contacts);
    if (!finder)
        return core::Unexpected(finder.error());
    return std::shared_ptr<CameraChannel>(new CameraChannel(
        std::move(source), camera, stop, std::move(reaction), settings, std::move(*finder)));
}

CameraChannel::CameraChannel(std::unique_ptr<core::CameraSource> source, const vision::CylinderCamera& camera,
                             const core::StopSwitch& stop, std::unique_ptr<CameraReaction> reaction,
                             const Settings& settings, std::unique_ptr<vision::ContactFinder> finder)
    : m_source(std::move(source))
    , m_camera(camera)
    , m_stop(stop)
    , m_reaction(std::move(reaction))
    , m_settings(settings)
    , m_tracker(std::move(finder), settings.tracker)
    , m_rung(&vision::contactLadder().front()) {
}

CameraChannel::~CameraChannel() {
    stop();
}

void CameraChannel::start() {
    if (m_thread.joinable())
        return;
    m_source->start(m_data);
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void CameraChannel::stop() {
    if (m_thread.joinable()) {
        m_thread.request_stop();
        m_data.notify();
        m_thread.join();
        m_thread = {};
    }
    m_source->stop();
}

void CameraChannel::chooseRung(const std::string& name) {
    m_rungs.post(name);
    m_data.notify();
}

void CameraChannel::renewReference() {
    m_referenceWanted.store(true, std::memory_order_release);
}

void CameraChannel::setMayReact(bool mayReact) {
    m_mayReact.store(mayReact, std::memory_order_release);
}

bool CameraChannel::mayReact() {
    if (m_stop.engaged())
        m_mayReact.store(false, std::memory_order_release);
    return m_mayReact.load(std::memory_order_acquire);
}

void CameraChannel::run(const std::stop_token& stop) {
    using namespace std::chrono_literals;
    constexpr auto kIdlePeriod = 50ms;
    const auto longestGap_ns = static_cast<std::int64_t>(kLongestGap_s * 1e9);
    while (!stop.stop_requested()) {
        m_data.waitFor(kIdlePeriod);
        takeWishes();
        (void)mayReact(); // STOP counts also while no frames come
        core::CameraFrame frame;
        core::CameraFrame newest;
        bool any = false;
        while (m_source->pop(frame)) {
            if (any)
                frame.replace(newest);
            newest = std::move(frame);
            any = true;
        }
        if (any)
            process(newest);
        else if (m_reaction && core::steadyNow_ns() - m_newest_ns > longestGap_ns)
            m_reaction->hold();
    }
    if (m_reaction)
        m_reaction->react({}, std::nullopt, false);
}

void CameraChannel::takeWishes() {
    if (m_referenceWanted.exchange(false, std::memory_order_acq_rel)) {
        m_tracker.renewReference();
        if (m_reaction)
            m_reaction->forget();
    }
    const std::optional<std::string> name = m_rungs.take();
    const vision::ContactRung* rung = name ? vision::contactRung(*name) : nullptr;
    if (rung == nullptr || rung == m_rung)
        return;
    auto finder = vision::makeContactFinder(*rung, m_camera, m_settings.contacts);
    core::Expected<void> changed = finder ? m_tracker.changeFinder(std::move(*finder))
                                          : core::Expected<void>(core::Unexpected(finder.error()));
    m_rungProblem = changed ? std::string() : changed.error().message;
    if (changed)
        m_rung = rung;
}

void CameraChannel::process(const core::CameraFrame& frame) {
    if (m_first_ns == 0)
        m_first_ns = frame.time_ns;
    if (frame.discontinuity || m_processed.load(std::memory_order_relaxed) == 0) {
        // Time goes on by at least a frame.
        m_offset_s =
            std::max(core::elapsed_s(m_first_ns, frame.time_ns), m_time_s + kLeastPeriod_s) - frame.capture_s;
        if (m_tracker.hasReference()) {
            m_tracker.forget();
            addEvent({.kind = CameraEvent::Kind::restart, .time_s = frame.capture_s + m_offset_s});
        }
        if (m_reaction)
            m_reaction->forget();
    }
    m_newest_ns = frame.time_ns;
    m_passedOver += frame.passedOver;
    m_time_s = frame.capture_s + m_offset_s;
    const std::int64_t begin_ns = core::steadyNow_ns();
    const bool hadReference = m_tracker.hasReference();
    const std::uint64_t unusable = m_tracker.unusableFrames();
    auto contacts = m_tracker.next(viewOf(frame.image), m_time_s);
    const bool usable = m_tracker.unusableFrames() == unusable;
    const std::int64_t end_ns = core::steadyNow_ns();
    if (!contacts)
        contacts = std::vector<FollowedContact>();
    const bool reacts = mayReact();
    if (m_reaction && usable)
        m_reaction->react(*contacts, m_tracker.bump(), reacts);
    if (!hadReference && m_tracker.hasReference())
        addEvent({.kind = CameraEvent::Kind::reference, .time_s = m_time_s});
    report(*contacts);
    if (!frame.image.isEmpty()) {
        m_lastImage = frame.image;
        m_lastPreview = previewOf(frame.image);
    }
    m_rate.add(frame.time_ns);
    m_processed.fetch_add(1, std::memory_order_relaxed);

    CameraSnapshot& snapshot = m_snapshots.back();
    snapshot.image = m_lastImage;
    snapshot.preview = m_lastPreview;
    snapshot.time_ns = frame.time_ns;
    snapshot.time_s = m_time_s;
    snapshot.frame = frame.number;
    snapshot.contacts = std::move(*contacts);
    snapshot.bump = m_tracker.bump();
    snapshot.carrier = m_reaction ? std::optional(m_reaction->report()) : std::nullopt;
    snapshot.surface = m_camera.surface();
    snapshot.hasReference = m_tracker.hasReference();
    snapshot.usable = usable;
    snapshot.problem = usable ? m_rungProblem : m_tracker.whyUnusable();
    snapshot.rung = m_rung->name;
    snapshot.mayReact = reacts;
    snapshot.stage_ns = m_tracker.finder().stageTimes_ns();
    snapshot.whole_ns = hadReference ? end_ns - begin_ns : 0;
    snapshot.processed_Hz = m_rate.rate_Hz(frame.time_ns);
    snapshot.processed = m_processed.load(std::memory_order_relaxed);
    snapshot.passedOver = m_passedOver;
    snapshot.unusable = m_tracker.unusableFrames();
    if (usable && hadReference)
        snapshot.arrows = m_tracker.finder().arrows(kArrows);
    else
        snapshot.arrows.clear();
    locate(snapshot);
    m_snapshots.publish();
}

void CameraChannel::locate(CameraSnapshot& snapshot) const {
    snapshot.covariances_m2.clear();
    for (const FollowedContact& followed : snapshot.contacts) {
        const auto covariance = m_camera.covariance_m2(followed.contact.p_Sensor_Centre_m);
        snapshot.covariances_m2.push_back(
            covariance && followed.contact.located
                ? *covariance
                : Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    }
    snapshot.vectors.clear();
    for (const vision::ContactFinder::Arrow& arrow : snapshot.arrows) {
        const Eigen::Vector2d at_px(arrow.at_px.x, arrow.at_px.y);
        const Eigen::Vector2d moved_px(arrow.moved_px.x, arrow.moved_px.y);
        const auto p_Sensor_m = m_camera.locate_m(at_px);
        const auto displacement_m = m_camera.tangentVector_m(at_px, at_px + moved_px);
        const auto sd_m = p_Sensor_m ? m_camera.standardDeviation_m(*p_Sensor_m)
                                     : tl::expected<double, vision::ProjectionFailure>(
                                           tl::unexpected(vision::ProjectionFailure::behindCamera));
        if (p_Sensor_m && displacement_m && sd_m && std::isfinite(*sd_m))
            snapshot.vectors.push_back({*p_Sensor_m, *displacement_m, *sd_m});
    }
}

void CameraChannel::report(const std::vector<FollowedContact>& contacts) {
    const auto eventOf = [&](CameraEvent::Kind kind, const FollowedContact& followed) {
        return CameraEvent{.kind = kind,
                           .time_s = m_time_s,
                           .contact = followed.contact.id,
                           .located = followed.contact.located,
                           .p_Sensor_m = followed.contact.p_Sensor_Centre_m,
                           .depth_m = followed.contact.depth_m};
    };
    const auto carrier = m_reaction ? m_reaction->report() : CarrierReport();
    const bool follows = carrier.doing == CarrierReport::Doing::follows && carrier.doing != m_doing;
    m_doing = carrier.doing;
    for (const FollowedContact& followed : contacts) {
        if (followed.event == ContactEvent::begins)
            addEvent(eventOf(CameraEvent::Kind::begins, followed));
        if (m_tracker.bump() && m_tracker.bump()->contact == followed.contact.id)
            addEvent(eventOf(CameraEvent::Kind::bumps, followed));
        if (follows && carrier.contact == followed.contact.id)
            addEvent(eventOf(CameraEvent::Kind::follows, followed));
        if (followed.event == ContactEvent::ends)
            addEvent(eventOf(CameraEvent::Kind::ends, followed));
    }
}

void CameraChannel::addEvent(CameraEvent event) {
    m_events.push(std::move(event));
}

} // namespace teleta::pipeline
