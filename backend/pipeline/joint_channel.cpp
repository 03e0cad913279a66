// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/joint_channel.h"

#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/recorder.h"
#include "backend/recording/stream_columns.h"

#include <algorithm>
#include <span>
#include <utility>

namespace teleta::pipeline {

JointChannel::JointChannel(std::unique_ptr<core::ArmSource> arm,
                           std::shared_ptr<const arm_model::SerialChain> chain, std::string meshFolder)
    : m_arm(std::move(arm))
    , m_chain(std::move(chain))
    , m_meshFolder(std::move(meshFolder))
    , m_samples(kHistorySamples) {
}

JointChannel::~JointChannel() {
    m_arm->stop();
}

void JointChannel::wearPad(const core::PadPlacement& pad, std::string framesStream) {
    m_pad = pad;
    m_padStream = std::move(framesStream);
}

ChannelSummary JointChannel::summary() const {
    const core::ArmDescription& arm = description();
    return {arm.name, arm.nominalRate_Hz, arm.simulated, arm.recorded, arm.guarded};
}

void JointChannel::drain() {
    core::JointSample sample;
    while (popSample(sample)) {
    }
}

bool JointChannel::hasProgram() const {
    return description().hasProgram && !description().recorded;
}

void JointChannel::record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) {
    recordJoints(recorder.get(), name, m_padStream);
}

void JointChannel::watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
                         const std::string& name) {
    watchJoints(who, sink.get(), name, m_padStream);
}

void JointChannel::recordJoints(recording::StreamSink* sink, const std::string& name,
                                const std::string& skinStream) {
    m_taps.set(tapInto(sink, name, skinStream));
}

void JointChannel::watchJoints(Watcher who, recording::StreamSink* sink, const std::string& name,
                               const std::string& skinStream) {
    m_watched[static_cast<std::size_t>(who)].set(tapInto(sink, name, skinStream));
}

JointChannel::Taps JointChannel::tapInto(recording::StreamSink* sink, const std::string& name,
                                         const std::string& skinStream) const {
    if (sink == nullptr)
        return {};
    Taps taps;
    core::ArmDescription described = description();
    described.pad = m_pad;
    taps.joints = sink->addStream(armStream(name + "-joints", described, skinStream, m_chain.get()));
    if (m_arm->wrenches() != nullptr)
        taps.wrench = sink->addStream(wrenchStream(name + "-wrench", description(), m_chain.get()));
    return taps;
}

std::size_t JointChannel::process() {
    const std::vector<core::JointSample>& samples = takeSamples();
    for (const core::JointSample& sample : samples)
        publish(sample);
    return samples.size();
}

const std::vector<core::JointSample>& JointChannel::takeSamples() {
    m_tapsInUse[0] = m_taps.get();
    std::ranges::transform(m_watched, m_tapsInUse.begin() + 1,
                           [](const auto& watched) { return watched.get(); });
    m_taken.clear();
    core::JointSample sample;
    core::BoundedQueue<core::JointSample>& joints = m_arm->joints();
    for (std::size_t waiting = joints.size(); waiting > 0 && joints.pop(sample); --waiting)
        m_taken.push_back(sample);
    if (!m_taken.empty())
        m_newestReading.set({m_taken.back().angle_rad, m_taken.back().time_ns});
    takeWrenches();
    return m_taken;
}

void JointChannel::takeWrenches() {
    core::BoundedQueue<core::WrenchSample>* wrenches = m_arm->wrenches();
    std::optional<core::WrenchSample> newest;
    core::WrenchSample sample;
    for (std::size_t waiting = wrenches != nullptr ? wrenches->size() : 0;
         waiting > 0 && wrenches->pop(sample); --waiting) {
        const auto values = wrenchValues(sample);
        for (const Taps& taps : m_tapsInUse)
            if (taps.wrench)
                taps.wrench->append(sample.time_ns, sample.sourceTime_s, std::span<const double>(values));
        newest = sample;
    }
    if (newest)
        m_newestWrench.set(newest);
}

void JointChannel::publish(const core::JointSample& sample) {
    for (const Taps& taps : m_tapsInUse) {
        if (!taps.joints)
            continue;
        const auto values = recording::jointValues(sample, description().joints());
        taps.joints->append(sample.time_ns, sample.sourceTime_s, std::span<const double>(values),
                            sample.discontinuity);
    }
    m_samples.push(core::JointSample(sample));
    m_samplesProcessed.fetch_add(1, std::memory_order_relaxed);
}

} // namespace teleta::pipeline
