// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/playback_outlet.h"

#include "backend/recording/stream_columns.h"

#include <utility>

namespace teleta::replay {

namespace {

constexpr std::size_t kFramesPerBlock = 64;
constexpr std::size_t kSamplesPerBatch = 64;

} // namespace

void ArrayPlaybackOutlet::open(core::Wakeup& consumer, std::int64_t now_ns) {
    m_block = {};
    m_outlet.open(consumer, now_ns);
}

void ArrayPlaybackOutlet::take(const PlaybackTrack& track, const PlayedFrame& frame) {
    const auto values = track.values<float>();
    m_block.channels = values.size();
    m_block.discontinuity = m_block.discontinuity || frame.jumped;
    m_block.time_ns.push_back(frame.time_ns);
    m_block.sourceTime_s.push_back(track.sourceTime_s());
    m_block.values.insert(m_block.values.end(), values.begin(), values.end());
}

bool ArrayPlaybackOutlet::isFull() const {
    return m_block.frames() >= kFramesPerBlock;
}

bool ArrayPlaybackOutlet::deliver(core::DeviceState state, bool canWait) {
    if (canWait) {
        if (!m_outlet.tryDeliver(m_block, state))
            return false;
    } else {
        m_outlet.deliver(std::move(m_block), state);
    }
    m_block = {};
    return true;
}

void CameraPlaybackOutlet::open(core::Wakeup& consumer, std::int64_t now_ns) {
    m_picture = {};
    m_outlet.open(consumer, now_ns);
}

void CameraPlaybackOutlet::take(const PlaybackTrack& track, const PlayedFrame& frame) {
    m_picture = {.image = track.image(),
                 .time_ns = frame.time_ns,
                 .capture_s = track.sourceTime_s(),
                 .number = m_outlet.framesRead(),
                 .discontinuity = frame.jumped,
                 .reference = frame.reference};
}

bool CameraPlaybackOutlet::deliver(core::DeviceState state, bool canWait) {
    if (canWait && m_outlet.isFull())
        return false;
    m_outlet.deliver(std::exchange(m_picture, {}), state);
    return true;
}

core::JointSample jointSampleAt(const PlaybackTrack& track, const PlayedFrame& frame) {
    core::JointSample sample = recording::jointSample(track.values<double>());
    sample.time_ns = frame.time_ns;
    sample.sourceTime_s = track.sourceTime_s();
    sample.discontinuity = frame.jumped;
    return sample;
}

core::WrenchSample wrenchSampleAt(const PlaybackTrack& track, std::int64_t time_ns) {
    const std::span<const double> values = track.values<double>();
    core::WrenchSample sample{.time_ns = time_ns, .sourceTime_s = track.sourceTime_s()};
    for (std::size_t axis = 0; axis < 3 && values.size() == 6; ++axis) {
        sample.force_N[axis] = values[axis];
        sample.torque_Nm[axis] = values[3 + axis];
    }
    return sample;
}

core::TemperatureSample temperatureSampleAt(const PlaybackTrack& track, const PlayedFrame& frame) {
    core::TemperatureSample sample{.time_ns = frame.time_ns,
                                   .sourceTime_s = track.sourceTime_s(),
                                   .values_degC = {},
                                   .discontinuity = frame.jumped};
    for (const double value : track.values<double>())
        sample.values_degC.push_back(static_cast<float>(value));
    return sample;
}

JointPlaybackOutlet::JointPlaybackOutlet(std::size_t queueSamples)
    : m_outlet(queueSamples, kSamplesPerBatch) {
}

void JointPlaybackOutlet::open(core::Wakeup& consumer, std::int64_t now_ns) {
    m_taken.clear();
    m_outlet.open(consumer, now_ns);
}

void JointPlaybackOutlet::take(const PlaybackTrack& track, const PlayedFrame& frame) {
    m_taken.push_back(jointSampleAt(track, frame));
}

bool JointPlaybackOutlet::isFull() const {
    return m_taken.size() >= kSamplesPerBatch;
}

bool JointPlaybackOutlet::deliver(core::DeviceState state, bool canWait) {
    core::BoundedQueue<core::JointSample>& queue = m_outlet.samples();
    if (canWait && queue.size() + m_taken.size() > queue.capacity())
        return false;
    const std::int64_t time_ns = m_taken.back().time_ns;
    for (core::JointSample& sample : m_taken)
        m_outlet.deliver(std::move(sample));
    m_taken.clear();
    m_outlet.flush();
    m_outlet.setState(state, time_ns);
    return true;
}

} // namespace teleta::replay
