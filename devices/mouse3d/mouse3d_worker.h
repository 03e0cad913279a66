// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/status_publisher.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/worker_wait.h"
#include "devices/mouse3d/hid_input.h"
#include "devices/mouse3d/mouse3d_config.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>

namespace teleta::mouse3d {

/// What the mouse reports now.
struct Mouse3dReading {
    SixAxes axes;              ///< as deflected, whether the dead-man button is held or not
    std::uint32_t buttons = 0; ///< bit i: button i is held
    /// Seen let go since the mouse was connected, or fell silent, pressed since, and held.
    bool deadManHeld = false;
    std::int64_t axesTime_ns = 0;  ///< steady time of the newest report of the axes
    std::int64_t time_ns = 0;      ///< of the newest report of axes or buttons
    std::int64_t suspended_ns = 0; ///< PacingClock::suspended_ns() at that report
};

/// Reads the reports of the mouse and looks for it when it is gone.
/// Thread: run() is the worker's; open() before it; the others from any.
class Mouse3dWorker {
public:
    Mouse3dWorker(HidInputOpener opener, Mouse3dConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token.
    void wake() { m_wait.wake(); }

    /// A mouse that has fallen silent counts as released and not deflected.
    [[nodiscard]] Mouse3dReading reading() const;
    [[nodiscard]] core::DeviceStatus status() const { return m_status.status(); }
    [[nodiscard]] std::string name() const { return m_name.get(); }
    /// Motion to apply: zero without the dead-man button and after the mouse has fallen silent.
    [[nodiscard]] SixAxes motion() const;

private:
    [[nodiscard]] bool connect(const std::stop_token& stop);
    void readReports(const std::stop_token& stop);
    void take(std::span<const std::uint8_t> report);
    [[nodiscard]] bool isSilent(const Mouse3dReading& reading) const;
    void letGoIfSilent();
    void forget();
    [[nodiscard]] std::int64_t now_ns() const { return m_wait.now_ns(); }

    HidInputOpener m_opener;
    Mouse3dConfig m_config;
    core::StatusPublisher m_status;
    core::WorkerWait m_wait;
    core::LatestCopy<Mouse3dReading> m_reading;
    core::LatestCopy<std::string> m_name;

    // The worker's own.
    std::unique_ptr<HidInput> m_input;
    RawAxes m_raw;
    bool m_deadManSeenReleased = false; ///< since the mouse was connected, or fell silent
    Mouse3dReading m_now;
};

} // namespace teleta::mouse3d
