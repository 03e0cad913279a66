// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/device.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/wakeup.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace teleta::simulated {

/// The worker's end of an arm's joints, as core::SourceOutlet for frames: queues samples, counts what is
/// lost, publishes the status, and wakes the consumer once a batch.
/// Thread: samples() is drained by one consumer, status() is for any; everything else is for the worker.
class JointOutlet {
public:
    JointOutlet(std::size_t queueSamples, std::size_t batchSamples);

    /// Begins a stream: counters start at 0, the state is connecting. Before the worker runs.
    void open(core::Wakeup& consumer, std::int64_t now_ns);
    /// Queues a sample; a full queue loses it, which is counted. The state becomes live. arrived_ns: when it
    /// came here; by default when it was read.
    void deliver(core::JointSample&& sample, std::optional<std::int64_t> arrived_ns = {});
    /// Counts samples that the device or its link lost.
    void lose(std::uint64_t samples);
    /// Ends a batch that is not full.
    void flush();
    /// Publishes a state unless it is already this one with this message.
    void setState(core::DeviceState state, std::int64_t now_ns, std::string message = {});

    [[nodiscard]] core::DeviceState state() const { return m_status.state; }
    [[nodiscard]] std::int64_t lastData_ns() const { return m_status.lastData_ns; }

    [[nodiscard]] core::BoundedQueue<core::JointSample>& samples() { return m_samples; }
    [[nodiscard]] core::DeviceStatus status() const { return m_published.get(); }

private:
    void enter(core::DeviceState state, std::int64_t now_ns, std::string message);
    void publish();
    void notify();

    core::BoundedQueue<core::JointSample> m_samples;
    std::size_t m_batchSamples;
    std::size_t m_inBatch = 0;
    core::RateMeter m_rate;
    core::DeviceStatus m_status;
    core::LatestCopy<core::DeviceStatus> m_published;
    core::Wakeup* m_consumer = nullptr;
    std::uint64_t m_lost = 0;           ///< by device and link
    std::uint64_t m_overflowAtOpen = 0; ///< the queue counts over all streams
};

} // namespace teleta::simulated
