// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/status_publisher.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace teleta::core {

/// The worker's end of an arm's joints, as SourceOutlet is for an array: queues samples, counts losses,
/// publishes the status and wakes the consumer once per batch.
/// Thread: samples() is drained by one consumer, status() and wakeAtEachSample() from any; the rest from the
/// worker's.
class JointOutlet {
public:
    JointOutlet(std::size_t queueSamples, std::size_t batchSamples);

    /// Starts a stream: counters begin at 0, the state is connecting. Before the worker runs.
    void open(Wakeup& consumer, std::int64_t now_ns);
    /// Queues a sample and enters the state live; what a full queue loses is counted. arrived_ns: when it
    /// arrived here; by default when it was read.
    void deliver(JointSample&& sample, std::optional<std::int64_t> arrived_ns = {});
    /// As core::ArmSource::wakeAtEachSample().
    void wakeAtEachSample(bool each) { m_wakesAtEach.store(each, std::memory_order_relaxed); }
    /// Counts samples that the device or its link lost.
    void lose(std::uint64_t samples);
    /// Ends a batch early.
    void flush();
    void setState(DeviceState state, std::int64_t now_ns, std::string message = {});

    [[nodiscard]] DeviceState state() const { return m_status.state(); }
    [[nodiscard]] std::int64_t lastData_ns() const { return m_status.current().lastData_ns; }

    [[nodiscard]] BoundedQueue<JointSample>& samples() { return m_samples; }
    [[nodiscard]] DeviceStatus status() const { return m_status.status(); }

private:
    BoundedQueue<JointSample> m_samples;
    std::size_t m_batchSamples;
    std::atomic<bool> m_wakesAtEach{false};
    std::size_t m_inBatch = 0;
    StatusPublisher m_status;
};

} // namespace teleta::core
