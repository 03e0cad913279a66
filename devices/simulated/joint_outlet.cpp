// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/joint_outlet.h"

#include <utility>

namespace teleta::simulated {

JointOutlet::JointOutlet(std::size_t queueSamples, std::size_t batchSamples)
    : m_samples(queueSamples)
    , m_batchSamples(batchSamples) {
}

void JointOutlet::open(core::Wakeup& consumer, std::int64_t now_ns) {
    m_consumer = &consumer;
    m_inBatch = 0;
    m_lost = 0;
    m_overflowAtOpen = m_samples.overflow();
    m_status = {};
    m_rate.reset();
    setState(core::DeviceState::connecting, now_ns);
}

void JointOutlet::deliver(core::JointSample&& sample, std::optional<std::int64_t> arrived_ns) {
    const std::int64_t time_ns = arrived_ns.value_or(sample.time_ns);
    m_samples.push(std::move(sample));
    m_status.lastData_ns = time_ns;
    ++m_status.framesRead;
    m_rate.add(time_ns);
    const bool isFirst = m_status.state != core::DeviceState::live;
    if (isFirst)
        enter(core::DeviceState::live, time_ns, {});
    publish();
    if (++m_inBatch >= m_batchSamples || isFirst)
        notify();
}

void JointOutlet::lose(std::uint64_t samples) {
    m_lost += samples;
    publish();
}

void JointOutlet::flush() {
    if (m_inBatch > 0)
        notify();
}

void JointOutlet::setState(core::DeviceState state, std::int64_t now_ns, std::string message) {
    if (state == m_status.state && message == m_status.message)
        return;
    enter(state, now_ns, std::move(message));
    publish();
    notify();
}

void JointOutlet::enter(core::DeviceState state, std::int64_t now_ns, std::string message) {
    m_status.state = state;
    m_status.since_ns = now_ns;
    m_status.message = std::move(message);
    if (state != core::DeviceState::live)
        m_rate.reset();
}

void JointOutlet::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(m_status.lastData_ns);
    m_status.framesLost = m_lost + (m_samples.overflow() - m_overflowAtOpen);
    m_published.set(m_status);
}

void JointOutlet::notify() {
    m_inBatch = 0;
    if (m_consumer != nullptr)
        m_consumer->notify();
}

} // namespace teleta::simulated
