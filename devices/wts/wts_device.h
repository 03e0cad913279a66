// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "devices/wts/wts_config.h"
#include "devices/wts/wts_worker.h"

#include <memory>

namespace teleta::wts {

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
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override {
        return m_worker.outlet().blocks();
    }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker.outlet().status(); }

    [[nodiscard]] const MatrixInfo& matrix() const { return m_matrix; }
    [[nodiscard]] WtsCounters counters() const { return m_worker.counters(); }

private:
    WtsDevice(WtsSession session, core::SourceDescription description, WtsConfig config);

    core::SourceDescription m_description;
    MatrixInfo m_matrix;
    WtsWorker m_worker;
    core::DeviceThread<WtsWorker> m_thread{m_worker};
};

} // namespace teleta::wts
