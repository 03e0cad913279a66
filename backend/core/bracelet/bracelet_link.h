// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/bracelet/bracelet_port.h"
#include "backend/core/bracelet/echo_ledger.h"
#include "backend/core/device/status_publisher.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/pacing_clock.h"
#include "backend/core/threads/stop_switch.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

namespace teleta::core {

struct BraceletLinkConfig {
    std::int64_t poll_ns = 10'000'000;        ///< between two looks at STOP and at reports
    std::int64_t idleWrite_ns = 100'000'000;  ///< without a frame for so long the device writes a zero one
    std::int64_t firstRetry_ns = 100'000'000; ///< before the first attempt to connect again, doubled for each
    std::int64_t longestRetry_ns = 2'000'000'000; ///< but no longer than this
    std::shared_ptr<PacingClock> clock = std::make_shared<PacingClock>();
};

/// A bracelet over any kind of port; keeps what BraceletSource promises about frames.
///   connecting -> live <-> stale; lost -> reconnecting -> connecting; stop(): closed
/// Reconnects after 0.1 s, then at intervals that grow to 2 s, and only to the same board (by its serial
/// number). Frames can be written from the state connecting on.
/// Thread: as core::BraceletSource.
class BraceletLink : public BraceletSource {
public:
    /// opened: the first result of opener. stopSwitch must outlive the link.
    BraceletLink(OpenedBracelet opened, BraceletOpener opener, const StopSwitch& stopSwitch,
                 BraceletLinkConfig config = {});

    [[nodiscard]] const BraceletDescription& description() const override { return m_description; }
    void start(Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] DeviceStatus status() const override { return m_status.status(); }
    [[nodiscard]] BraceletTelemetry telemetry() const override { return m_telemetry.get(); }
    [[nodiscard]] std::uint64_t connection() const override {
        return m_publishedConnection.load(std::memory_order_acquire);
    }
    WriteResult write(const BraceletFrame& frame) override;

private:
    friend class DeviceThread<BraceletLink>;
    using Lock = std::unique_lock<std::mutex>;

    void open(Wakeup& consumer);
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token.
    void wake();

    [[nodiscard]] bool reconnect(Lock& lock, const std::stop_token& stop);
    void closePort(Lock& lock);
    void adopt(std::unique_ptr<BraceletPort> port);
    void lose();
    [[nodiscard]] bool send(const Drive& drive, std::uint16_t timeout_ms);
    void writeZeroIfDue();
    void readReports();
    void checkAge();
    void setState(DeviceState state, std::string message = {});
    void publish();
    void publishTelemetry();
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }

    BraceletDescription m_description;
    BraceletOpener m_opener;
    const StopSwitch& m_stopSwitch;
    BraceletLinkConfig m_config;
    std::int64_t m_staleAfter_ns;

    std::mutex m_mutex; ///< of what follows
    std::condition_variable m_condition;
    std::unique_ptr<BraceletPort> m_port;
    bool m_connected = false;
    std::uint64_t m_connections = 0;
    std::int64_t m_lastWrite_ns = 0;
    EchoLedger m_ledger;
    StatusPublisher m_status;
    BraceletTelemetry m_telemetryNow;

    LatestCopy<BraceletTelemetry> m_telemetry;
    std::atomic<std::uint64_t> m_publishedConnection{0};
    DeviceThread<BraceletLink> m_thread{*this}; ///< last, so that it ends first
};

} // namespace teleta::core
