// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/backoff.h"
#include "backend/core/device/device.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/latest_copy.h"
#include "devices/link/frame_clock.h"
#include "devices/link/wake_pipe.h"
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

/// A Weiss WTS tactile array on a serial port or over TCP.
///   connecting -> live <-> stale; unplugged, closed or silent: lost -> reconnecting -> connecting; stop():
///   closed
/// Values are the sensor's counts. Reconnects only to an array of the same layout. stop() tells the sensor to
/// send no more frames.
/// Thread: open, start and stop from one controlling thread, counters from any; otherwise as
/// core::TactileSource.
class WtsDevice : public core::TactileSource {
public:
    /// Connects and asks for the array, which may take some seconds when nothing answers.
    /// Error: as WtsSession::open.
    [[nodiscard]] static core::Expected<std::unique_ptr<WtsDevice>> open(WtsConfig config);

    [[nodiscard]] const core::SourceDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override { return m_outlet.blocks(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    [[nodiscard]] const MatrixInfo& matrix() const { return m_matrix; }
    [[nodiscard]] WtsCounters counters() const { return m_published.get(); }

private:
    WtsDevice(WtsSession session, core::SourceDescription description, WtsConfig config);

    friend core::DeviceThread<WtsDevice>;
    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_wake.wake(); }

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

    core::SourceDescription m_description;
    WtsConfig m_config;
    MatrixInfo m_matrix;
    std::int64_t m_staleAfter_ns;
    std::int64_t m_lostAfter_ns;
    core::SourceOutlet m_outlet;
    core::LatestCopy<WtsCounters> m_published;
    link::WakePipe m_wake;

    // The worker's own.
    std::unique_ptr<WtsSession> m_session;
    link::FrameClock m_clock;
    WtsCounters m_counters;
    MessageDecoder::Counters m_closedLines; ///< of the connections before this one
    std::vector<float> m_values;
    std::int64_t m_begin_ns = 0;     ///< of the stream
    std::int64_t m_lastFrame_ns = 0; ///< or the begin of the connection
    core::Backoff m_retry;           ///< before the next attempt to connect
    bool m_tarePending = false;
    bool m_discontinuity = false; ///< of the next block

    core::DeviceThread<WtsDevice> m_thread{*this};
};

} // namespace teleta::wts
