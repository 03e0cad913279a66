// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/wakeup.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::core {

/// The worker's end of a tactile source: numbers and queues its blocks, counts what is lost, publishes its
/// status and wakes the consumer.
/// Thread: blocks() is drained by one consumer, status() is for any; everything else is for the worker.
class SourceOutlet {
public:
    explicit SourceOutlet(std::size_t queueBlocks)
        : m_blocks(queueBlocks) {}

    /// Begins a stream: frame numbers and counters start at 0, the state is connecting. Before the worker
    /// runs.
    void open(Wakeup& consumer, std::int64_t now_ns);

    /// Numbers a block and queues it; a full queue loses it, which is counted. The state becomes this one.
    /// block: at least one frame, its firstFrame is overwritten. arrived_ns: when it came here; by default
    /// when its frames were read.
    void deliver(SampleBlock&& block, DeviceState state, std::optional<std::int64_t> arrived_ns = {});

    /// The same for a worker that can wait: false when the queue is full, and then nothing happened.
    [[nodiscard]] bool tryDeliver(SampleBlock& block, DeviceState state);

    /// Counts frames that the device or its link lost: their numbers are skipped.
    void lose(std::uint64_t frames);

    /// Publishes a state unless it is already this one with this message.
    void setState(DeviceState state, std::int64_t now_ns, std::string message = {});

    [[nodiscard]] DeviceState state() const { return m_status.state; }
    [[nodiscard]] std::int64_t lastData_ns() const { return m_status.lastData_ns; }

    [[nodiscard]] BoundedQueue<SampleBlock>& blocks() { return m_blocks; }
    [[nodiscard]] DeviceStatus status() const { return m_published.get(); }

private:
    void begin(SampleBlock& block);
    void finish(DeviceState state, std::optional<std::int64_t> arrived_ns = {});
    void enter(DeviceState state, std::int64_t now_ns, std::string message);
    void publish();

    BoundedQueue<SampleBlock> m_blocks;
    RateMeter m_rate;
    DeviceStatus m_status;
    LatestCopy<DeviceStatus> m_published;
    std::vector<std::int64_t> m_time_ns; ///< of the block at hand, which is moved into the queue
    Wakeup* m_consumer = nullptr;
    std::uint64_t m_nextFrame = 0;
    std::uint64_t m_lost = 0;           ///< by device and link
    std::uint64_t m_overflowAtOpen = 0; ///< the queue counts over all streams
};

} // namespace teleta::core
