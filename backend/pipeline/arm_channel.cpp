// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/arm_channel.h"

#include "backend/core/failure.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/pipeline/touch/skin_contact.h"
#include "backend/recording/recorder.h"

#include <limits>
#include <numbers>
#include <span>
#include <utility>

namespace teleta::pipeline {

ArmChannel::ArmChannel(std::unique_ptr<core::ArmSource> arm, std::shared_ptr<TouchChannel> skin,
                       const ArmSettings& settings)
    : ArmChannel(std::move(arm), std::move(skin), settings, nullptr, nullptr, {}) {
}

core::Expected<std::shared_ptr<ArmChannel>>
ArmChannel::withPad(std::unique_ptr<core::ArmSource> arm, std::shared_ptr<TouchChannel> skin,
                    std::shared_ptr<const arm_model::SerialChain> chain, const core::PadPlacement& pad,
                    std::string meshFolder) {
    TELETA_TRY(auto skinAt, padOnLink(chain, pad));
    ArmSettings settings;
    settings.touch = touchSettings(pad.torques);
    std::shared_ptr<ArmChannel> channel(new ArmChannel(std::move(arm), std::move(skin), settings,
                                                       std::move(skinAt), std::move(chain),
                                                       std::move(meshFolder)));
    channel->wearPad(pad, {});
    return channel;
}

ArmChannel::ArmChannel(std::unique_ptr<core::ArmSource> arm, std::shared_ptr<TouchChannel> skin,
                       const ArmSettings& settings, std::shared_ptr<const SkinKinematics> skinAt,
                       std::shared_ptr<const arm_model::SerialChain> chain, std::string meshFolder)
    : JointChannel(std::move(arm), std::move(chain), std::move(meshFolder))
    , m_skin(std::move(skin))
    , m_estimator(description(), settings.touch, skinAt)
    , m_skinTouches(description().joints(), skinAt ? std::move(skinAt) : skinAroundForearm(description()))
    , m_found(settings.contour)
    , m_touches(kHistoryTouches) {
    m_settingsInUse.set(settings);
}

ArmChannel::~ArmChannel() {
    JointChannel::stop(); // before the skin, into which its thread delivers
}

void ArmChannel::start(core::Wakeup& data) {
    m_skin->start(data);
    JointChannel::start(data);
}

void ArmChannel::stop() {
    JointChannel::stop();
    m_skin->stop();
}

void ArmChannel::drain() {
    m_skin->drain();
    JointChannel::drain();
    TouchRecord touch;
    while (popTouch(touch)) {
    }
}

void ArmChannel::record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) {
    m_skin->record(recorder, name);
    recordJoints(recorder.get(), name, framesStreamName(name));
    m_touchTap.set(recorder ? recorder->addStream(touchStream(name + "-touches", description())) : nullptr);
}

void ArmChannel::watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
                       const std::string& name) {
    m_skin->watch(who, sink, name);
    watchJoints(who, sink.get(), name, framesStreamName(name));
    m_touchesWatched[static_cast<std::size_t>(who)].set(
        sink ? sink->addStream(touchStream(name + "-touches", description())) : nullptr);
}

std::size_t ArmChannel::process() {
    bool changed = takeCommands();

    // Joints first: a skin frame that was read before them is then there, too.
    const std::vector<core::JointSample>& joints = takeSamples();
    m_contacts.clear();
    const double circumference_m = 2.0 * std::numbers::pi * description().skin.radius_m;
    m_skin->process(
        [&](const TouchSnapshot& frame) { m_contacts.push_back(strongestContact(frame, circumference_m)); });

    auto contact = m_contacts.begin();
    const auto feedContactsUntil = [&](std::int64_t time_ns) {
        for (; contact != m_contacts.end() && contact->time_ns <= time_ns; ++contact) {
            if (auto touch = m_tellsTorques ? m_estimator.update(*contact)
                                            : m_skinTouches.update(*contact, m_estimator.settings()))
                take(std::move(*touch));
        }
    };
    for (const core::JointSample& next : joints) {
        feedContactsUntil(next.time_ns - 1);
        if (!m_tellsTorques && tellsTorques(next)) {
            m_tellsTorques = true;
            m_estimator.countFrom(m_skinTouches.touches());
        }
        if (auto touch = m_tellsTorques ? m_estimator.update(next)
                                        : m_skinTouches.update(next, m_estimator.settings()))
            take(std::move(*touch));
        // A touch that the jump ended is of the run before.
        if (m_sourceTime_s && next.sourceTime_s < *m_sourceTime_s && !description().recorded)
            beginAnew(next.time_ns);
        m_sourceTime_s = next.sourceTime_s;
        publish(next);
    }
    feedContactsUntil(std::numeric_limits<std::int64_t>::max());
    device().wakeAtEachSample(m_tellsTorques && m_estimator.isNearlyComplete());

    changed = changed || !joints.empty() || !m_contacts.empty();
    if (!joints.empty())
        m_newest = joints.back();
    if (changed)
        publishSnapshot();
    return joints.size();
}

bool ArmChannel::takeCommands() {
    bool changed = false;
    if (const auto settings = m_changes.take()) {
        m_estimator.setSettings(settings->touch);
        m_found.setSettings(settings->contour);
        m_history.settingsChanged();
        ++m_objectsRevision;
        m_settingsInUse.set(*settings);
        changed = true;
    }
    if (m_contourReset.exchange(false, std::memory_order_acq_rel)) {
        m_found.closeAll();
        m_history.closeObject();
        changed = true;
    }
    return changed;
}

void ArmChannel::take(TouchRecord&& touch) {
    // A recording's numbers its touches anew, which all that follows shows.
    const auto kind = description().recorded ? m_history.add(touch) : TouchHistory::Kind::first;
    // What is felt first: recognising the shape takes about 1 ms.
    const std::shared_ptr<TactileFeedback> feedback = m_feedback.get();
    if (feedback)
        feedback->onTouch(touch);
    addToObjects(touch, kind);
    const auto tapInto = [&touch](const std::shared_ptr<core::StreamTap>& tap) {
        if (!tap)
            return;
        const auto values = touchValues(touch);
        tap->append(touch.ready_ns, touch.ready_s, std::span<const double>(values));
    };
    tapInto(m_touchTap.get());
    for (const auto& watched : m_touchesWatched)
        tapInto(watched.get());
    if (touch.located && feedback)
        feedback->onContour(touch, m_found.contour());
    m_lastTouch = touch;
    m_touches.push(std::move(touch));
}

void ArmChannel::addToObjects(const TouchRecord& touch, TouchHistory::Kind kind) {
    using Kind = TouchHistory::Kind;
    if (kind == Kind::better) {
        m_history.fill(m_found);
        ++m_objectsRevision;
    } else if (kind == Kind::first && m_found.add(touch) != nullptr) {
        ++m_objectsRevision;
    }
}

void ArmChannel::beginAnew(std::int64_t time_ns) {
    m_begun_ns = time_ns;
    m_found.clear();
    ++m_objectsRevision;
    m_lastTouch.reset();
}

void ArmChannel::publishSnapshot() {
    ArmSnapshot& snapshot = m_snapshots.back();
    snapshot.newest = m_newest;
    snapshot.drive = device().drive();
    snapshot.begun_ns = m_begun_ns;
    snapshot.contact = m_tellsTorques ? m_estimator.liveContact() : m_skinTouches.liveContact();
    snapshot.lastTouch = m_lastTouch;
    // The slot may hold this contour already: it is large and seldom new.
    if (snapshot.contour.revision != m_found.contour().revision)
        snapshot.contour = m_found.contour();
    if (snapshot.objectsRevision != m_objectsRevision) {
        snapshot.objects = m_found.objects();
        snapshot.objectsRevision = m_objectsRevision;
    }
    snapshot.samplesProcessed = samplesProcessed();
    m_snapshots.publish();
}

} // namespace teleta::pipeline
