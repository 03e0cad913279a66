// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_outlet.h"

#include <utility>

namespace teleta::replay {

namespace {

constexpr std::size_t kRecordedFramesPerBlock = 64;

} // namespace

void RecordedArrayOutlet::open(core::Wakeup& consumer, std::int64_t now_ns) {
    m_block = {};
    m_outlet.open(consumer, now_ns);
}

void RecordedArrayOutlet::take(const RecordedTrack& track, const PlayedFrame& frame) {
    const auto values = track.values<float>();
    m_block.channels = values.size();
    m_block.discontinuity = m_block.discontinuity || frame.jumped;
    m_block.time_ns.push_back(frame.time_ns);
    m_block.sourceTime_s.push_back(frame.sourceTime_s);
    m_block.values.insert(m_block.values.end(), values.begin(), values.end());
}

bool RecordedArrayOutlet::isFull() const {
    return m_block.frames() >= kRecordedFramesPerBlock;
}

bool RecordedArrayOutlet::deliver(core::DeviceState state, bool canWait) {
    if (canWait) {
        if (!m_outlet.tryDeliver(m_block, state))
            return false;
    } else {
        m_outlet.deliver(std::move(m_block), state);
    }
    m_block = {};
    return true;
}

void RecordedCameraOutlet::open(core::Wakeup& consumer, std::int64_t now_ns) {
    m_consumer = &consumer;
    m_picture = {};
    m_status = {};
    m_rate.reset();
    setState(core::DeviceState::connecting, now_ns, {});
}

void RecordedCameraOutlet::take(const RecordedTrack& track, const PlayedFrame& frame) {
    m_picture = {.image = track.image(),
                 .time_ns = frame.time_ns,
                 .capture_s = frame.sourceTime_s,
                 .number = m_status.framesRead,
                 .discontinuity = frame.jumped,
                 .reference = frame.reference};
}

bool RecordedCameraOutlet::deliver(core::DeviceState state, bool canWait) {
    if (canWait && m_frames.size() >= m_frames.capacity())
        return false;
    ++m_status.framesRead;
    m_status.lastData_ns = m_picture.time_ns;
    m_rate.add(m_picture.time_ns);
    m_frames.push(std::exchange(m_picture, {}));
    if (state != m_status.state)
        setState(state, m_status.lastData_ns, {});
    else
        publish();
    return true;
}

void RecordedCameraOutlet::setState(core::DeviceState state, std::int64_t now_ns, std::string message) {
    if (state == m_status.state && message == m_status.message)
        return;
    m_status.state = state;
    m_status.since_ns = now_ns;
    m_status.message = std::move(message);
    if (state != core::DeviceState::live)
        m_rate.reset();
    publish();
}

void RecordedCameraOutlet::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(m_status.lastData_ns);
    m_published.set(m_status);
    if (m_consumer != nullptr)
        m_consumer->notify();
}

} // namespace teleta::replay
