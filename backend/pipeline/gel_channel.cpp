// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/gel_channel.h"

#include "backend/core/steady_time.h"
#include "backend/pipeline/recorded/recorded_camera.h"
#include "backend/pipeline/recorded/recorded_gel.h"
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/recording/event_words.h"
#include "backend/recording/recorder.h"
#include "backend/vision/finders/picture_view.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace teleta::pipeline {

namespace {

constexpr double kLeastGelPeriod_s = 0.001;

using Kind = GelEvent::Kind;
using vision::GelContactState;
using vision::viewOf;

/// In the order of GelEvent::Kind.
constexpr std::array kGelEventWords{recording::kContactBegins, recording::kIncipientSlip, recording::kSlip,
                                    recording::kContactEnds,   recording::kReference,     recording::kRestart,
                                    recording::kPictureDark,   recording::kLightJump,     recording::kGelTorn,
                                    recording::kBump,          recording::kFollows};

std::vector<cv::Mat1b> viewsOf(const std::vector<core::GreyImage>& pictures) {
    std::vector<cv::Mat1b> views;
    views.reserve(pictures.size());
    for (const core::GreyImage& picture : pictures)
        views.push_back(viewOf(picture));
    return views;
}

std::vector<int> idsOf(const std::vector<GelContactState>& contacts) {
    std::vector<int> ids;
    ids.reserve(contacts.size());
    for (const GelContactState& contact : contacts)
        ids.push_back(contact.id);
    return ids;
}

} // namespace

GelChannel::GelChannel(std::unique_ptr<core::CameraSource> source, vision::MarkerGelFile file,
                       core::GreyImage reference)
    : m_source(std::move(source))
    , m_file(std::move(file))
    , m_description(m_source->description())
    , m_follower(m_file)
    , m_recordedRest(std::move(reference)) {
    m_description.name = m_file.name;
}

void GelChannel::setReaction(std::unique_ptr<GelReaction> reaction, const core::StopSwitch& stop) {
    m_reaction = std::move(reaction);
    m_permission.emplace(stop);
    m_permission->give(true);
}

GelChannel::~GelChannel() {
    stop();
}

ChannelSummary GelChannel::summary() const {
    return {m_description.name, m_description.nominalRate_Hz, m_description.simulated,
            m_description.recorded};
}

void GelChannel::drain() {
    GelEvent event;
    while (popEvent(event)) {
    }
}

void GelChannel::record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) {
    m_taps.set(recorder ? tapsInto(recorder, name) : nullptr);
}

void GelChannel::watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
                       const std::string& name) {
    m_watched[static_cast<std::size_t>(who)].set(sink ? tapsInto(sink, name) : nullptr);
}

std::shared_ptr<const GelTaps> GelChannel::tapsInto(const std::shared_ptr<recording::StreamSink>& sink,
                                                    const std::string& name) const {
    const std::string reference = name + "-reference";
    const equilibration::LoadCalibration* calibration = m_loads ? &m_loads->calibration() : nullptr;
    auto taps = std::make_shared<GelTaps>();
    taps->reference = sink->addStream(gelReferenceStream(reference, m_description));
    taps->pictures =
        sink->addStream(gelStream(name + "-camera", m_description, m_file, reference, calibration));
    taps->contacts = sink->addStream(gelContactStream(name + "-contacts", m_description, calibration));
    taps->event = [weak = std::weak_ptr<recording::StreamSink>(sink), name](const GelEvent& event,
                                                                            std::int64_t time_ns) {
        if (const auto kept = weak.lock())
            kept->add({.time_ns = time_ns,
                       .kind = kGelEventWords[static_cast<std::size_t>(event.kind)],
                       .text = name,
                       .value = static_cast<double>(event.contact)});
    };
    return taps;
}

void GelChannel::start(core::Wakeup& /*data*/) {
    if (m_thread.joinable())
        return;
    m_source->start(m_data);
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void GelChannel::stop() {
    if (m_thread.joinable()) {
        m_thread.request_stop();
        m_data.notify();
        m_thread.join();
        m_thread = {};
    }
    m_source->stop();
}

void GelChannel::setMayReact(bool mayReact) {
    if (!m_permission)
        return;
    m_permission->give(mayReact);
    m_data.notify();
}

void GelChannel::renewReference() {
    m_referenceWanted.store(true, std::memory_order_release);
}

void GelChannel::run(const std::stop_token& stop) {
    using namespace std::chrono_literals;
    constexpr auto kIdlePeriod = 50ms;
    while (!stop.stop_requested()) {
        m_data.waitFor(kIdlePeriod);
        takeTaps();
        core::CameraFrame next;
        bool isNext = m_source->pop(next);
        if (!isNext) {
            stand();
            publishChanges();
        }
        while (isNext && !stop.stop_requested()) {
            takeTaps(); // the queue may never be empty
            core::CameraFrame frame = std::move(next);
            next = {};
            isNext = m_source->pop(next);
            if (isNext && core::elapsed_s(frame.time_ns, core::steadyNow_ns()) > kOldest_s)
                passOver(frame);
            else
                process(std::move(frame));
        }
    }
    if (m_reaction)
        m_reaction->react({}, m_time_s, 0.0, false);
}

void GelChannel::react() {
    if (!m_reaction)
        return;
    if (!m_permission->isGiven() || !m_follower.usable()) {
        stand();
        return;
    }
    m_usable_ns = m_frame_ns;
    const vision::MarkerGel& gel = m_follower.gel();
    const int bumped =
        m_reaction->react(m_follower.contacts(), m_time_s, gel.scale_m() * gel.noise_px(), true);
    const CarrierReport arm = m_reaction->report();
    const bool isFollowing = arm.doing == CarrierReport::Doing::follows;
    const int followed = isFollowing && arm.contact != m_following ? arm.contact : 0;
    if (isFollowing || arm.doing != CarrierReport::Doing::held || arm.contact != m_following)
        m_following = isFollowing ? arm.contact : 0;
    for (const GelContactState& contact : m_follower.contacts()) {
        if (contact.id == bumped)
            addEvent(eventOf(Kind::bumps, contact));
        if (contact.id == followed)
            addEvent(eventOf(Kind::follows, contact));
    }
}

void GelChannel::stand() {
    if (!m_reaction)
        return;
    if (!m_permission->isGiven())
        m_reaction->react({}, m_time_s, 0.0, false);
    else if (core::elapsed_s(m_usable_ns, core::steadyNow_ns()) > kLongestGap_s)
        m_reaction->hold();
}

void GelChannel::publishChanges() {
    if (!m_reaction || m_now.processed == 0)
        return;
    const CarrierReport before = m_now.carrier.value_or(CarrierReport());
    const bool mightReact = m_now.mayReact;
    m_now.carrier = m_reaction->report();
    m_now.mayReact = m_permission->isGiven();
    if (m_permission->takeAsked() || m_now.mayReact != mightReact || m_now.carrier->doing != before.doing ||
        m_now.carrier->contact != before.contact)
        publish();
}

void GelChannel::publish() {
    m_snapshots.back() = m_now;
    m_snapshots.publish();
}

void GelChannel::passOver(const core::CameraFrame& frame) {
    std::string why;
    recordPicture(frame, partOf(frame, why));
    m_restarts = m_restarts || frame.discontinuity;
    if (!frame.reference.isEmpty())
        m_recordedRest = frame.reference;
    m_passedOver += frame.passedOver + 1;
}

core::GreyImage GelChannel::partOf(const core::CameraFrame& frame, std::string& why) const {
    if (frame.image.isEmpty() || (m_file.crop.empty() && !m_file.flipX && !m_file.flipY))
        return frame.image;
    auto part = vision::MarkerGel::part(m_file, viewOf(frame.image));
    if (!part) {
        why = part.error().message;
        return {};
    }
    // It may share the frame's pixels, which then go.
    return core::greyImageOf(part->clone());
}

void GelChannel::restart(const core::CameraFrame& frame) {
    const bool isFirst = m_processed.load(std::memory_order_relaxed) == 0;
    endContacts(idsOf(m_follower.contacts()));
    // Time goes on by at least a frame.
    m_offset_s =
        std::max(core::elapsed_s(m_first_ns, frame.time_ns), m_time_s + kLeastGelPeriod_s) - frame.capture_s;
    m_follower.forget();
    if (m_reaction)
        m_reaction->forget();
    if (!isFirst)
        addEvent({.kind = Kind::restart, .time_s = frame.capture_s + m_offset_s, .slipIndex = {}});
}

void GelChannel::process(core::CameraFrame frame) {
    if (m_first_ns == 0)
        m_first_ns = frame.time_ns;
    m_frame_ns = frame.time_ns;
    const bool isFirst = m_processed.load(std::memory_order_relaxed) == 0;
    if (std::exchange(m_restarts, false) || frame.discontinuity || isFirst)
        restart(frame);
    m_time_s = frame.capture_s + m_offset_s;
    m_passedOver += frame.passedOver;
    std::string why;
    const core::GreyImage part = partOf(frame, why);
    recordPicture(frame, part);
    const std::int64_t begin_ns = core::steadyNow_ns();
    if (m_referenceWanted.exchange(false, std::memory_order_acq_rel))
        m_follower.renewReference();
    const std::size_t references = m_follower.references();
    if (!frame.reference.isEmpty())
        m_recordedRest = frame.reference;
    if (!part.isEmpty() && !m_recordedRest.isEmpty())
        takeRecordedRest(part);
    const std::vector<int> before = idsOf(m_follower.contacts());
    const vision::GelFaults faultsBefore = m_follower.faults();
    m_follower.next(viewOf(part), m_time_s);
    const std::int64_t work_ns = core::steadyNow_ns() - begin_ns;
    if (m_follower.references() != references) {
        stackRest();
        addEvent({.kind = Kind::reference, .time_s = m_time_s, .slipIndex = {}});
        recordReference(frame.time_ns);
    }
    report(before, faultsBefore);
    react();
    recordContacts(frame);
    if (!part.isEmpty())
        m_lastImage = part;
    if (!m_follower.usable() && m_follower.hasReference())
        ++m_unusable;
    m_rate.add(frame.time_ns);
    m_processed.fetch_add(1, std::memory_order_relaxed);
    publish(frame, work_ns, why);
}

void GelChannel::publish(const core::CameraFrame& frame, std::int64_t work_ns, const std::string& why) {
    GelSnapshot& now = m_now;
    now.image = m_lastImage;
    now.time_ns = frame.time_ns;
    now.time_s = m_time_s;
    now.frame = frame.number;
    now.contacts = m_follower.contacts();
    now.loads.clear();
    if (m_loads) {
        now.loadNames = m_loads->calibration().loads;
        for (const GelContactState& contact : now.contacts)
            now.loads.push_back(m_loads->at(contact));
    }
    if (m_follower.hasReference()) {
        const vision::MarkerGel& gel = m_follower.gel();
        now.markers = gel.markers();
        now.motions = gel.motions();
        for (vision::GelMotion& motion : now.motions)
            motion.found = motion.found && m_follower.usable();
        now.scale_m = gel.scale_m();
        now.noise_m = gel.scale_m() * gel.noise_px();
        now.corners_m = gel.corners_m();
    } else {
        now.markers.clear();
        now.motions.clear();
        now.scale_m = 0.0;
        now.noise_m = 0.0;
    }
    now.missing = m_follower.missing();
    now.usable = m_follower.usable();
    now.problem = why.empty() ? m_follower.problem() : why;
    now.work_ns = work_ns;
    now.processed_Hz = m_rate.rate_Hz(frame.time_ns);
    now.processed = m_processed.load(std::memory_order_relaxed);
    now.passedOver = m_passedOver;
    now.unusable = m_unusable;
    if (m_reaction) {
        now.carrier = m_reaction->report();
        now.mayReact = m_permission->isGiven();
    }
    publish();
}

void GelChannel::takeRecordedRest(const core::GreyImage& part) {
    const auto pictures =
        unstackedReference(std::exchange(m_recordedRest, {}), part.width_px, part.height_px);
    const std::vector<int> open = idsOf(m_follower.contacts());
    // The follower tells what is wrong with it.
    if (m_follower.setReference(viewsOf(pictures)))
        endContacts(open);
}

void GelChannel::endContacts(const std::vector<int>& ids) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    for (const int id : ids)
        addEvent({.kind = Kind::ends,
                  .time_s = m_time_s,
                  .contact = id,
                  .centre_m = {kUnknown, kUnknown},
                  .shear_m = {kUnknown, kUnknown},
                  .slipIndex = {}});
}

GelEvent GelChannel::eventOf(GelEvent::Kind kind, const GelContactState& contact) const {
    return {.kind = kind,
            .time_s = m_time_s,
            .contact = contact.id,
            .centre_m = contact.centre_m,
            .shear_m = contact.shearProxy_m,
            .slipIndex = contact.slipIndex};
}

void GelChannel::report(const std::vector<int>& before, const vision::GelFaults& faultsBefore) {
    const std::vector<GelContactState>& contacts = m_follower.contacts();
    std::vector<int> ended;
    std::ranges::copy_if(before, std::back_inserter(ended), [&contacts](int id) {
        return std::ranges::find(contacts, id, &GelContactState::id) == contacts.end();
    });
    endContacts(ended);
    for (const GelContactState& contact : contacts) {
        if (std::ranges::find(before, contact.id) == before.end())
            addEvent(eventOf(Kind::begins, contact));
        if (contact.event == vision::SlipEvent::incipientSlip)
            addEvent(eventOf(Kind::incipientSlip, contact));
        if (contact.event == vision::SlipEvent::slip)
            addEvent(eventOf(Kind::slip, contact));
    }
    const vision::GelFaults& faults = m_follower.faults();
    const auto tell = [&](bool is, bool was, Kind kind) {
        if (is && !was)
            addEvent({.kind = kind, .time_s = m_time_s, .slipIndex = {}});
    };
    tell(faults.dead, faultsBefore.dead, Kind::dark);
    tell(faults.lightJumped && !faults.dead, faultsBefore.lightJumped, Kind::lightJump);
    tell(faults.torn, faultsBefore.torn, Kind::torn);
}

void GelChannel::takeTaps() {
    const auto take = [this](std::shared_ptr<const GelTaps> taps, std::shared_ptr<const GelTaps>& inUse) {
        if (taps == inUse)
            return;
        inUse = std::move(taps);
        recordReference(inUse, core::steadyNow_ns());
    };
    take(m_taps.get(), m_tapsInUse.front());
    for (std::size_t i = 0; i < kWatchers; ++i)
        take(m_watched[i].get(), m_tapsInUse[1 + i]);
}

void GelChannel::recordPicture(const core::CameraFrame& frame, const core::GreyImage& part) {
    for (const auto& taps : m_tapsInUse)
        if (taps)
            taps->pictures->append({.image = part,
                                    .time_ns = frame.time_ns,
                                    .capture_s = frame.capture_s,
                                    .discontinuity = frame.discontinuity});
}

void GelChannel::recordReference(std::int64_t time_ns) {
    for (const auto& taps : m_tapsInUse)
        recordReference(taps, time_ns);
}

void GelChannel::recordReference(const std::shared_ptr<const GelTaps>& taps, std::int64_t time_ns) {
    if (taps && !m_rest.isEmpty())
        taps->reference->append({.image = m_rest, .time_ns = time_ns, .capture_s = m_time_s - m_offset_s});
}

void GelChannel::stackRest() {
    std::vector<core::GreyImage> pictures;
    for (const cv::Mat1b& picture : m_follower.reference())
        pictures.push_back(core::greyImageOf(picture));
    m_rest = stackedReference(pictures);
}

void GelChannel::recordContacts(const core::CameraFrame& frame) {
    for (const auto& taps : m_tapsInUse) {
        if (!taps)
            continue;
        for (const GelContactState& contact : m_follower.contacts()) {
            const auto proxies = gelContactValues(contact);
            std::vector<double> values(proxies.begin(), proxies.end());
            if (m_loads)
                std::ranges::copy(loadValues(m_loads->at(contact)), std::back_inserter(values));
            taps->contacts->append(frame.time_ns, frame.capture_s, std::span<const double>(values));
        }
    }
}

void GelChannel::addEvent(GelEvent event) {
    for (const auto& taps : m_tapsInUse) {
        if (taps && taps->event)
            taps->event(event, m_frame_ns);
    }
    m_events.push(std::move(event));
}

} // namespace teleta::pipeline
