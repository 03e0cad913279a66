// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/wakeup.h"

#include <cstdint>
#include <span>
#include <string>

namespace teleta::core {

/// The status of a device as its worker keeps and publishes it.
///   - DeviceStatus::since_ns changes with the state only; a new message for the same state keeps it.
///   - The rate starts over whenever the device enters a state other than live.
///   - Received data clears the message.
/// Thread: status() from any; the rest from the worker's, open() before it runs.
class StatusPublisher {
public:
    /// Starts over: all counters are 0 and the state is connecting.
    void open(Wakeup& consumer, std::int64_t now_ns);

    /// Enters a state, publishes and wakes the consumer. Does nothing if state and message are unchanged.
    void setState(DeviceState state, std::int64_t now_ns, std::string message = {});

    /// Counts frames that arrived at these times (at least one, not decreasing) and enters the state that
    /// they prove, as of the last of them. Returns true if the state changed. Call publish() afterwards.
    bool receive(DeviceState state, std::span<const std::int64_t> arrived_ns);
    bool receive(DeviceState state, std::int64_t arrived_ns) { return receive(state, {&arrived_ns, 1}); }
    /// Frames that were lost: some more, or in total since open(). Call publish() afterwards.
    void lose(std::uint64_t frames) { m_status.framesLost += frames; }
    void setLost(std::uint64_t frames) { m_status.framesLost = frames; }

    void publish();
    void wakeConsumer();
    void publishAndWake() {
        publish();
        wakeConsumer();
    }

    /// What the worker knows, published or not.
    [[nodiscard]] const DeviceStatus& current() const { return m_status; }
    [[nodiscard]] DeviceState state() const { return m_status.state; }
    /// What was published last.
    [[nodiscard]] DeviceStatus status() const { return m_published.get(); }

private:
    void enter(DeviceState state, std::int64_t now_ns, std::string message);

    RateMeter m_rate;
    DeviceStatus m_status;
    LatestCopy<DeviceStatus> m_published;
    Wakeup* m_consumer = nullptr;
};

} // namespace teleta::core
