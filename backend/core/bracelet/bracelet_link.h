// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/bracelet/bracelet_port.h"
#include "backend/core/bracelet/bracelet_worker.h"
#include "backend/core/threads/device_thread.h"

namespace teleta::core {

/// A bracelet over any kind of port.
///   connecting -> live <-> stale; lost -> reconnecting -> connecting; stop(): closed
/// Attempts to connect again wait 0.1 s and ever longer, up to 2 s, and take the same board only, by its
/// serial number. Frames can be written from connecting on.
/// Thread: as core::BraceletSource.
class BraceletLink : public BraceletSource {
public:
    /// opened: what opener gave, or would have given. stopSwitch must outlive the link.
    BraceletLink(OpenedBracelet opened, BraceletOpener opener, const StopSwitch& stopSwitch,
                 BraceletLinkConfig config = {});
    ~BraceletLink() override;

    [[nodiscard]] const BraceletDescription& description() const override { return m_worker.description(); }
    void start(Wakeup& consumer) override;
    void stop() override;
    [[nodiscard]] DeviceStatus status() const override { return m_worker.status(); }
    [[nodiscard]] BraceletTelemetry telemetry() const override { return m_worker.telemetry(); }
    [[nodiscard]] std::uint64_t connection() const override { return m_worker.connection(); }
    WriteResult write(const BraceletFrame& frame) override { return m_worker.write(frame); }

private:
    BraceletWorker m_worker;
    DeviceThread m_thread;
};

} // namespace teleta::core
