// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/camera_channel.h"

#include "backend/core/steady_time.h"
#include "backend/pipeline/recorded/recorded_camera.h"
#include "backend/recording/event_words.h"
#include "backend/recording/recorder.h"
#include "backend/vision/finders/picture_view.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

namespace teleta::pipeline {

namespace {

constexpr double kLeastPeriod_s = 0.025;

using vision::ContactEvent;
using vision::FollowedContact;
using vision::viewOf;

core::GreyImage previewOf(const core::GreyImage& image) {
    const cv::Mat1b whole = viewOf(image);
    if (whole.empty() || whole.cols <= CameraChannel::kPreview_px)
        return image;
    const double scale = static_cast<double>(CameraChannel::kPreview_px) / whole.cols;
    cv::Mat1b small;
    cv::resize(whole, small, {}, scale, scale, cv::INTER_AREA);
    return core::greyImageOf(std::move(small));
}

/// In the order of CameraEvent::Kind.
constexpr std::array kEventWords{recording::kContactBegins, recording::kBump,      recording::kContactEnds,
                                 recording::kFollows,       recording::kReference, recording::kRestart};

} // namespace

core::Expected<std::shared_ptr<CameraChannel>> CameraChannel::make(std::unique_ptr<core::CameraSource> source,
                                                                   const vision::CylinderCamera& camera,
                                                                   const core::StopSwitch& stop,
                                                                   std::unique_ptr<CameraReaction> reaction,
                                                                   const Settings& settings) {
    std::stop_source stopping;
    TELETA_TRY(auto finder, vision::makeContactFinder(vision::contactLadder().front(), camera,
                                                      settings.contacts, stopping.get_token()));
    std::shared_ptr<CameraChannel> channel(new CameraChannel(
        std::move(source), camera, stop, std::move(reaction), settings, std::move(finder), stopping));
    if (!settings.reference.isEmpty()) {
        TELETA_CHECK(channel->m_tracker.next(viewOf(settings.reference), 0.0));
    }
    return channel;
}

CameraChannel::CameraChannel(std::unique_ptr<core::CameraSource> source, const vision::CylinderCamera& camera,
                             const core::StopSwitch& stop, std::unique_ptr<CameraReaction> reaction,
                             const Settings& settings, std::unique_ptr<vision::ContactFinder> finder,
                             std::stop_source stopping)
    : m_source(std::move(source))
    , m_camera(camera)
    , m_permission(stop)
    , m_reaction(std::move(reaction))
    , m_settings(settings)
    , m_stopping(std::move(stopping))
    , m_tracker(std::move(finder), settings.tracker)
    , m_rung(&vision::contactLadder().front()) {
    setMayReact(true);
}

CameraChannel::~CameraChannel() {
    stop();
}

ChannelSummary CameraChannel::summary() const {
    const core::CameraDescription& description = m_source->description();
    return {description.name, description.nominalRate_Hz, description.simulated, description.recorded};
}

void CameraChannel::drain() {
    CameraEvent event;
    while (popEvent(event)) {
    }
}

void CameraChannel::record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) {
    m_taps.set(recorder ? tapsInto(recorder, name) : nullptr);
}

void CameraChannel::watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
                          const std::string& name) {
    m_watched[static_cast<std::size_t>(who)].set(sink ? tapsInto(sink, name) : nullptr);
}

std::shared_ptr<const CameraTaps> CameraChannel::tapsInto(const std::shared_ptr<recording::StreamSink>& sink,
                                                          const std::string& name) const {
    const core::CameraDescription& description = m_source->description();
    const std::string reference = name + "-reference";
    auto taps = std::make_shared<CameraTaps>();
    taps->reference = sink->addStream(referenceStream(reference, description));
    taps->pictures = sink->addStream(
        cameraStream(name + "-camera", description, m_camera, m_settings.tracker.bump, reference));
    taps->contacts = sink->addStream(contactStream(name + "-contacts", description));
    taps->event = [weak = std::weak_ptr<recording::StreamSink>(sink), name](const CameraEvent& event,
                                                                            std::int64_t time_ns) {
        if (const auto kept = weak.lock())
            kept->add({.time_ns = time_ns,
                       .kind = kEventWords[static_cast<std::size_t>(event.kind)],
                       .text = name,
                       .value = static_cast<double>(event.contact)});
    };
    return taps;
}

void CameraChannel::start(core::Wakeup& /*data*/) {
    if (m_thread.joinable())
        return;
    m_source->start(m_data);
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void CameraChannel::stop() {
    m_stopping.request_stop();
    if (m_thread.joinable()) {
        m_thread.request_stop();
        m_data.notify();
        m_thread.join();
        m_thread = {};
    }
    if (m_maker.joinable())
        m_maker.join();
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
    m_permission.give(mayReact);
    m_data.notify();
}

bool CameraChannel::mayReact() const {
    return m_permission.isGiven();
}

void CameraChannel::run(const std::stop_token& stop) {
    using namespace std::chrono_literals;
    constexpr auto kIdlePeriod = 50ms;
    while (!stop.stop_requested()) {
        m_data.waitFor(kIdlePeriod);
        takeWishes();
        takeTaps();
        core::CameraFrame frame;
        core::CameraFrame newest;
        bool any = false;
        while (m_source->pop(frame)) {
            for (const auto& taps : m_tapsInUse)
                if (taps)
                    taps->pictures->append(frame);
            if (any)
                frame.replace(newest);
            newest = std::move(frame);
            any = true;
        }
        if (any) {
            process(newest);
        } else {
            react(nullptr, core::steadyNow_ns());
            publishChanges();
        }
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
    takeRungs();
}

void CameraChannel::takeRungs() {
    if (const std::optional<std::string> name = m_rungs.take()) {
        if (const vision::ContactRung* rung = vision::contactRung(*name)) {
            m_wantedRung = rung != m_rung ? rung : nullptr;
            m_refusedRung = nullptr;
        }
    }
    if (std::optional<ReadyFinder> ready = m_ready.take()) {
        if (m_maker.joinable())
            m_maker.join();
        m_makingRung = nullptr;
        // Meanwhile another one may have been asked for.
        if (ready->rung == m_wantedRung) {
            const core::Expected<void> changed =
                ready->finder ? m_tracker.changeFinder(std::move(*ready->finder), ready->reference)
                              : core::Expected<void>(core::Unexpected(ready->finder.error()));
            if (changed) {
                m_rung = m_wantedRung;
            } else {
                m_refusedRung = m_wantedRung;
                m_whyRefused = changed.error().message;
            }
            m_wantedRung = nullptr;
        }
    }
    if (m_wantedRung != nullptr && m_makingRung == nullptr)
        makeReady(*m_wantedRung);
}

void CameraChannel::makeReady(const vision::ContactRung& rung) {
    m_makingRung = &rung;
    m_maker = std::jthread([this, &rung, reference = m_tracker.reference()] {
        ReadyFinder ready{
            &rung, vision::makeContactFinder(rung, m_camera, m_settings.contacts, m_stopping.get_token()),
            reference};
        if (ready.finder && !reference.empty()) {
            if (const auto taken = (*ready.finder)->setReference(reference); !taken)
                ready.finder = core::Unexpected(taken.error());
        }
        m_ready.post(std::move(ready));
        m_data.notify();
    });
}

void CameraChannel::process(const core::CameraFrame& frame) {
    if (m_first_ns == 0)
        m_first_ns = frame.time_ns;
    m_frame_ns = frame.time_ns;
    const bool isFirst = m_processed.load(std::memory_order_relaxed) == 0;
    if (frame.discontinuity || isFirst) {
        // Time goes on by at least a frame.
        m_offset_s =
            std::max(core::elapsed_s(m_first_ns, frame.time_ns), m_time_s + kLeastPeriod_s) - frame.capture_s;
        if (m_tracker.hasReference()) {
            m_tracker.forget();
            if (!isFirst)
                addEvent({.kind = CameraEvent::Kind::restart, .time_s = frame.capture_s + m_offset_s});
        }
        if (m_reaction)
            m_reaction->forget();
    }
    m_passedOver += frame.passedOver;
    m_time_s = frame.capture_s + m_offset_s;
    const std::int64_t begin_ns = core::steadyNow_ns();
    if (!frame.reference.isEmpty())
        takeReference(frame);
    const bool hadReference = m_tracker.hasReference();
    const std::uint64_t unusable = m_tracker.unusableFrames();
    auto contacts = m_tracker.next(viewOf(frame.image), m_time_s);
    const bool usable = m_tracker.unusableFrames() == unusable;
    const std::int64_t end_ns = core::steadyNow_ns();
    if (!contacts)
        contacts = std::vector<FollowedContact>();
    if (usable)
        m_usable_ns = frame.time_ns;
    react(usable ? &*contacts : nullptr, frame.time_ns);
    if (!hadReference && m_tracker.hasReference())
        addEvent({.kind = CameraEvent::Kind::reference, .time_s = m_time_s});
    if (!hadReference)
        recordReference(frame.time_ns, frame.capture_s);
    recordContacts(frame, *contacts);
    report(*contacts);
    if (!frame.image.isEmpty()) {
        m_lastImage = frame.image;
        m_lastPreview = previewOf(frame.image);
    }
    m_rate.add(frame.time_ns);
    m_processed.fetch_add(1, std::memory_order_relaxed);

    m_now.image = m_lastImage;
    m_now.preview = m_lastPreview;
    m_now.time_ns = frame.time_ns;
    m_now.time_s = m_time_s;
    m_now.frame = frame.number;
    m_now.contacts = std::move(*contacts);
    m_now.bump = m_tracker.bump();
    m_now.surface = m_camera.surface();
    m_now.hasReference = m_tracker.hasReference();
    m_now.usable = usable;
    m_now.problem = usable ? std::string() : m_tracker.whyUnusable();
    m_now.stage_ns = m_tracker.finder().stageTimes_ns();
    m_now.whole_ns = hadReference ? end_ns - begin_ns : 0;
    m_now.processed_Hz = m_rate.rate_Hz(frame.time_ns);
    m_now.processed = m_processed.load(std::memory_order_relaxed);
    m_now.passedOver = m_passedOver;
    m_now.unusable = m_tracker.unusableFrames();
    if (usable && hadReference)
        m_now.arrows = m_tracker.finder().arrows(kArrows);
    else
        m_now.arrows.clear();
    locate(m_now);
    refresh(m_now);
    publish();
}

void CameraChannel::takeReference(const core::CameraFrame& frame) {
    m_tracker.renewReference();
    if (m_reaction)
        m_reaction->forget();
    // Otherwise the frame itself is the reference.
    if (m_tracker.next(viewOf(frame.reference), m_time_s)) {
        addEvent({.kind = CameraEvent::Kind::reference, .time_s = m_time_s});
        recordReference(frame.time_ns, frame.capture_s);
    }
}

void CameraChannel::react(const std::vector<FollowedContact>* contacts, std::int64_t now_ns) {
    if (!m_reaction)
        return;
    if (!mayReact())
        m_reaction->react({}, std::nullopt, false);
    else if (contacts != nullptr)
        m_reaction->react(*contacts, m_tracker.bump(), true);
    else if (core::elapsed_s(m_usable_ns, now_ns) > kLongestGap_s)
        m_reaction->hold();
}

void CameraChannel::refresh(CameraSnapshot& snapshot) const {
    const auto nameOf = [](const vision::ContactRung* rung) {
        return rung != nullptr ? rung->name : std::string_view();
    };
    snapshot.carrier = m_reaction ? std::optional(m_reaction->report()) : std::nullopt;
    snapshot.mayReact = mayReact();
    snapshot.rung = nameOf(m_rung);
    snapshot.nextRung = nameOf(m_wantedRung);
    snapshot.refusedRung = nameOf(m_refusedRung);
    snapshot.whyRefused = m_refusedRung != nullptr ? m_whyRefused : std::string();
}

void CameraChannel::publishChanges() {
    if (m_now.processed == 0)
        return;
    const auto shown = [](const CameraSnapshot& snapshot) {
        const CarrierReport carrier = snapshot.carrier.value_or(CarrierReport());
        return std::tuple(carrier.doing, carrier.contact, snapshot.mayReact, snapshot.rung, snapshot.nextRung,
                          snapshot.refusedRung);
    };
    const auto before = shown(m_now);
    const bool asked = m_permission.takeAsked();
    refresh(m_now);
    if (asked || shown(m_now) != before)
        publish();
}

void CameraChannel::publish() {
    m_snapshots.back() = m_now;
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
    const bool isFollowing = carrier.doing == CarrierReport::Doing::follows;
    const bool follows = isFollowing && carrier.contact != m_following;
    if (isFollowing || carrier.doing != CarrierReport::Doing::held || carrier.contact != m_following)
        m_following = isFollowing ? carrier.contact : 0;
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

void CameraChannel::takeTaps() {
    const auto take = [this](std::shared_ptr<const CameraTaps> taps,
                             std::shared_ptr<const CameraTaps>& inUse) {
        if (taps == inUse)
            return;
        inUse = std::move(taps);
        recordReference(inUse, core::steadyNow_ns(), m_time_s - m_offset_s);
    };
    take(m_taps.get(), m_tapsInUse.front());
    for (std::size_t i = 0; i < kWatchers; ++i)
        take(m_watched[i].get(), m_tapsInUse[1 + i]);
}

void CameraChannel::recordReference(std::int64_t time_ns, double capture_s) {
    for (const auto& taps : m_tapsInUse)
        recordReference(taps, time_ns, capture_s);
}

void CameraChannel::recordReference(const std::shared_ptr<const CameraTaps>& taps, std::int64_t time_ns,
                                    double capture_s) {
    // Nobody writes to the reference's pixels.
    if (taps && m_tracker.hasReference())
        taps->reference->append(
            {.image = core::greyImageOf(m_tracker.reference()), .time_ns = time_ns, .capture_s = capture_s});
}

void CameraChannel::recordContacts(const core::CameraFrame& frame,
                                   const std::vector<FollowedContact>& contacts) {
    for (const auto& taps : m_tapsInUse) {
        if (!taps)
            continue;
        for (const FollowedContact& followed : contacts) {
            if (!followed.seen && followed.event != ContactEvent::ends)
                continue;
            const auto values = contactValues(followed);
            taps->contacts->append(frame.time_ns, frame.capture_s, std::span<const double>(values));
        }
    }
}

void CameraChannel::addEvent(CameraEvent event) {
    for (const auto& taps : m_tapsInUse) {
        if (taps && taps->event)
            taps->event(event, m_frame_ns);
    }
    m_events.push(std::move(event));
}

} // namespace teleta::pipeline
