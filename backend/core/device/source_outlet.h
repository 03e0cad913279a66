// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/status_publisher.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::core {

/// The worker's end of a tactile source: numbers and queues its blocks, counts losses, publishes the status
/// and wakes the consumer.
/// Thread: blocks() is drained by one consumer, status() from any; the rest from the worker's.
class SourceOutlet {
public:
    explicit SourceOutlet(std::size_t queueBlocks)
        : m_blocks(queueBlocks) {}

    /// Starts a stream: frame numbers and counters begin at 0, the state is connecting. Before the worker
    /// runs.
    void open(Wakeup& consumer, std::int64_t now_ns);

    /// Numbers a block, queues it and enters a state; what a full queue loses is counted.
    /// block: at least one frame; its firstFrame is overwritten. arrived_ns: when it arrived here; by default
    /// when its frames were read.
    void deliver(SampleBlock&& block, DeviceState state, std::optional<std::int64_t> arrived_ns = {});

    /// The same for a worker that can wait: returns false and changes nothing when the queue is full.
    [[nodiscard]] bool tryDeliver(SampleBlock& block, DeviceState state);

    /// Counts frames that the device or its link lost; their numbers are skipped.
    void lose(std::uint64_t frames);

    void setState(DeviceState state, std::int64_t now_ns, std::string message = {}) {
        m_status.setState(state, now_ns, std::move(message));
    }

    [[nodiscard]] DeviceState state() const { return m_status.state(); }
    [[nodiscard]] std::int64_t lastData_ns() const { return m_status.current().lastData_ns; }

    [[nodiscard]] BoundedQueue<SampleBlock>& blocks() { return m_blocks; }
    [[nodiscard]] DeviceStatus status() const { return m_status.status(); }

private:
    void begin(SampleBlock& block);
    void finish(DeviceState state);

    BoundedQueue<SampleBlock> m_blocks;
    StatusPublisher m_status;
    std::vector<std::int64_t> m_time_ns; ///< arrival times of the current block, which moves into the queue
    std::uint64_t m_nextFrame = 0;
};

} // namespace teleta::core
