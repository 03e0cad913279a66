// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/status_publisher.h"

#include <utility>

namespace teleta::core {

void StatusPublisher::open(Wakeup& consumer, std::int64_t now_ns) {
    m_consumer = &consumer;
    m_status = {};
    m_rate.reset();
    setState(DeviceState::connecting, now_ns);
}

void StatusPublisher::setState(DeviceState state, std::int64_t now_ns, std::string message) {
    if (state == m_status.state && message == m_status.message)
        return;
    enter(state, now_ns, std::move(message));
    publishAndWake();
}

bool StatusPublisher::receive(DeviceState state, std::span<const std::int64_t> arrived_ns) {
    m_status.framesRead += arrived_ns.size();
    m_status.lastData_ns = arrived_ns.back();
    for (const std::int64_t time_ns : arrived_ns)
        m_rate.add(time_ns);
    const bool changed = state != m_status.state;
    if (changed)
        enter(state, m_status.lastData_ns, {});
    else
        m_status.message.clear();
    return changed;
}

void StatusPublisher::enter(DeviceState state, std::int64_t now_ns, std::string message) {
    if (state != m_status.state)
        m_status.since_ns = now_ns;
    m_status.state = state;
    m_status.message = std::move(message);
    if (state != DeviceState::live)
        m_rate.reset();
}

void StatusPublisher::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(m_status.lastData_ns);
    m_published.set(m_status);
}

void StatusPublisher::wakeConsumer() {
    if (m_consumer != nullptr)
        m_consumer->notify();
}

} // namespace teleta::core
