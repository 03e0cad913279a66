// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/backoff.h"
#include "backend/core/device/device.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/threads/latest_copy.h"
#include "devices/wts/frame_clock.h"
#include "devices/wts/wake_pipe.h"
#include "devices/wts/wts_config.h"
#include "devices/wts/wts_session.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::wts {

/// What came over the link since the source was started. Frames lost by gaps in the sensor's timestamps are
/// in core::DeviceStatus::framesLost.
struct WtsCounters {
    MessageDecoder::Counters line;    ///< over all connections
    std::uint64_t faultyFrames = 0;   ///< right checksum, but not a frame of this array
    std::uint64_t otherMessages = 0;  ///< neither a frame nor expected
    std::uint64_t sensorRestarts = 0; ///< timestamps that jumped back
    std::uint64_t connections = 0;    ///< including the first one
    std::uint64_t failedAttempts = 0; ///< to connect again

    bool operator==(const WtsCounters&) const = default;
};

/// Reads, stamps and delivers the frames of a sensor; connects again when it was lost.
/// Thread: run() is the worker's; open() before it; wake() and counters() from any.
class WtsWorker {
public:
    WtsWorker(WtsSession session, const core::SourceDescription& description, WtsConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token.
    void wake() { m_wake.wake(); }

    [[nodiscard]] WtsCounters counters() const { return m_published.get(); }
    [[nodiscard]] core::SourceOutlet& outlet() { return m_outlet; }
    [[nodiscard]] const core::SourceOutlet& outlet() const { return m_outlet; }

private:
    [[nodiscard]] core::Expected<void> connect();
    [[nodiscard]] core::Expected<void> beginFrames();
    /// Reads frames until stop or a loss; returns why the sensor was lost.
    [[nodiscard]] std::string stream(const std::stop_token& stop);
    void deliverFrames(MessageDecoder::Rest rest);
    void appendFrame(const Message& message, core::SampleBlock& block);
    void deliver(core::SampleBlock& block);
    /// After a loss: waits and tries until there is a session again, or stop.
    void reconnect(std::string reason, const std::stop_token& stop);
    void closeSession();
    void publish();

    WtsConfig m_config;
    MatrixInfo m_matrix;
    std::int64_t m_staleAfter_ns;
    std::int64_t m_lostAfter_ns;
    core::SourceOutlet m_outlet;
    core::LatestCopy<WtsCounters> m_published;
    WakePipe m_wake;

    // The worker's own.
    std::unique_ptr<WtsSession> m_session;
    FrameClock m_clock;
    WtsCounters m_counters;
    MessageDecoder::Counters m_closedLines; ///< of the connections before this one
    std::vector<float> m_values;
    std::int64_t m_begin_ns = 0;     ///< of the stream
    std::int64_t m_lastFrame_ns = 0; ///< or the begin of the connection
    core::Backoff m_retry;           ///< before the next attempt to connect
    bool m_tarePending = false;
    bool m_discontinuity = false; ///< of the next block
};

} // namespace teleta::wts
