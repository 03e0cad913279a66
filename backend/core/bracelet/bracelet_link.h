// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/bracelet/bracelet_port.h"
#include "backend/core/bracelet/bracelet_worker.h"
#include "backend/core/threads/device_thread.h"

#include <utility>

namespace teleta::core {

/// A bracelet over any kind of port.
///   connecting -> live <-> stale; lost -> reconnecting -> connecting; stop(): closed
/// Reconnects after 0.1 s, then at intervals that grow to 2 s, and only to the same board (by its serial
/// number). Frames can be written from the state connecting on.
/// Thread: as core::BraceletSource.
class BraceletLink : public BraceletSource {
public:
    /// opened: the first result of opener. stopSwitch must outlive the link.
    BraceletLink(OpenedBracelet opened, BraceletOpener opener, const StopSwitch& stopSwitch,
                 BraceletLinkConfig config = {})
        : m_worker(std::move(opened), std::move(opener), stopSwitch, std::move(config)) {}

    [[nodiscard]] const BraceletDescription& description() const override { return m_worker.description(); }
    void start(Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] DeviceStatus status() const override { return m_worker.status(); }
    [[nodiscard]] BraceletTelemetry telemetry() const override { return m_worker.telemetry(); }
    [[nodiscard]] std::uint64_t connection() const override { return m_worker.connection(); }
    WriteResult write(const BraceletFrame& frame) override { return m_worker.write(frame); }

private:
    BraceletWorker m_worker;
    DeviceThread<BraceletWorker> m_thread{m_worker};
};

} // namespace teleta::core
