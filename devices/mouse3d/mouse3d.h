// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/status_publisher.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/worker_wait.h"
#include "devices/mouse3d/hid_input.h"
#include "devices/mouse3d/mouse3d_motion.h"

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

namespace teleta::mouse3d {

struct Mouse3dConfig {
    MotionLimits limits{};
    int deadManButton = 0; ///< 0 .. 31; motion counts only while it is held
    /// A deflected cap reports without pause; one that is silent for so long counts as at rest.
    std::int64_t axesLifetime_ns = 200'000'000;
    /// A cap at rest does not report. A dead-man button that is held while nothing comes for so long counts
    /// as let go: its release may have been lost.
    std::int64_t restLifetime_ns = 3'000'000'000;
    int readTimeout_ms = 50; ///< after which the worker looks at its stop token
    std::int64_t firstRetry_ns = 250'000'000;
    std::int64_t longestRetry_ns = 2'000'000'000;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

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

/// A six-axis mouse with a dead-man button, whose worker looks for it when it is gone.
///   connecting -> live; unplugged: lost -> reconnecting -> live; stop(): closed
/// Thread: start and stop from one controlling thread; the rest by any.
class Mouse3d {
public:
    /// opener: by default the first mouse that hidapi finds.
    explicit Mouse3d(Mouse3dConfig config = {}, HidInputOpener opener = openFirstMouse);

    /// Starts the worker, which notifies the consumer of reports and changes of state.
    void start(core::Wakeup& consumer) { m_thread.start(consumer); }
    /// Ends the worker and waits for it, at most readTimeout_ms. Idempotent.
    void stop() { m_thread.stop(); }

    /// Motion to apply now: zero without the dead-man button, without a mouse, and when the reports of a
    /// deflected cap stop; the button has to be pressed again then.
    [[nodiscard]] SixAxes motion() const;
    /// A mouse that has fallen silent counts as released and not deflected.
    [[nodiscard]] Mouse3dReading reading() const;
    [[nodiscard]] core::DeviceStatus status() const { return m_status.status(); }
    /// Of the mouse that is, or was last, connected; empty before that.
    [[nodiscard]] std::string name() const { return m_name.get(); }

private:
    friend core::DeviceThread<Mouse3d>;
    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_wait.wake(); }

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
    std::unique_ptr<hid::HidDevice> m_input;
    RawAxes m_raw;
    bool m_deadManSeenReleased = false; ///< since the mouse was connected, or fell silent
    Mouse3dReading m_now;

    core::DeviceThread<Mouse3d> m_thread{*this};
};

} // namespace teleta::mouse3d
