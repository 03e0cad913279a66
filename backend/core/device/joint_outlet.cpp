// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/joint_outlet.h"

#include <utility>

namespace teleta::core {

JointOutlet::JointOutlet(std::size_t queueSamples, std::size_t batchSamples)
    : m_samples(queueSamples)
    , m_batchSamples(batchSamples) {
}

void JointOutlet::open(Wakeup& consumer, std::int64_t now_ns) {
    m_inBatch = 0;
    m_status.open(consumer, now_ns);
}

void JointOutlet::deliver(JointSample&& sample, std::optional<std::int64_t> arrived_ns) {
    const std::int64_t time_ns = arrived_ns.value_or(sample.time_ns);
    if (!m_samples.push(std::move(sample)))
        m_status.lose(1);
    const bool isFirst = m_status.receive(DeviceState::live, time_ns);
    m_status.publish();
    if (++m_inBatch >= m_batchSamples || isFirst || m_wakesAtEach.load(std::memory_order_relaxed))
        flush();
}

void JointOutlet::lose(std::uint64_t samples) {
    m_status.lose(samples);
    m_status.publish();
}

void JointOutlet::flush() {
    if (std::exchange(m_inBatch, 0) > 0)
        m_status.wakeConsumer();
}

void JointOutlet::setState(DeviceState state, std::int64_t now_ns, std::string message) {
    if (state != m_status.state())
        m_inBatch = 0;
    m_status.setState(state, now_ns, std::move(message));
}

} // namespace teleta::core
