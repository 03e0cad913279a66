// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/source_outlet.h"

#include <utility>

namespace teleta::core {

void SourceOutlet::open(Wakeup& consumer, std::int64_t now_ns) {
    m_consumer = &consumer;
    m_nextFrame = 0;
    m_lost = 0;
    m_overflowAtOpen = m_blocks.overflow();
    m_status = {};
    m_rate.reset();
    setState(DeviceState::connecting, now_ns);
}

void SourceOutlet::deliver(SampleBlock&& block, DeviceState state, std::optional<std::int64_t> arrived_ns) {
    begin(block);
    m_blocks.push(std::move(block), m_time_ns.size());
    finish(state, arrived_ns);
}

bool SourceOutlet::tryDeliver(SampleBlock& block, DeviceState state) {
    begin(block);
    if (!m_blocks.tryPush(block))
        return false;
    finish(state);
    return true;
}

void SourceOutlet::begin(SampleBlock& block) {
    block.firstFrame = m_nextFrame;
    m_time_ns.assign(block.time_ns.begin(), block.time_ns.end());
}

void SourceOutlet::finish(DeviceState state, std::optional<std::int64_t> arrived_ns) {
    m_nextFrame += m_time_ns.size();
    m_status.framesRead += m_time_ns.size();
    m_status.lastData_ns = arrived_ns.value_or(m_time_ns.back());
    for (const std::int64_t time_ns : m_time_ns)
        m_rate.add(arrived_ns.value_or(time_ns));
    if (state != m_status.state)
        enter(state, m_status.lastData_ns, {});
    publish();
}

void SourceOutlet::lose(std::uint64_t frames) {
    m_nextFrame += frames;
    m_lost += frames;
    publish();
}

void SourceOutlet::setState(DeviceState state, std::int64_t now_ns, std::string message) {
    if (state == m_status.state && message == m_status.message)
        return;
    enter(state, now_ns, std::move(message));
    publish();
}

void SourceOutlet::enter(DeviceState state, std::int64_t now_ns, std::string message) {
    m_status.state = state;
    m_status.since_ns = now_ns;
    m_status.message = std::move(message);
    if (state != DeviceState::live)
        m_rate.reset();
}

void SourceOutlet::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(m_status.lastData_ns);
    m_status.framesLost = m_lost + (m_blocks.overflow() - m_overflowAtOpen);
    m_published.set(m_status);
    if (m_consumer != nullptr)
        m_consumer->notify();
}

} // namespace teleta::core
