// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/wakeup.h"
#include "devices/mouse3d/hid_input.h"
#include "devices/mouse3d/mouse3d_config.h"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

namespace teleta::mouse3d {

/// What the mouse tells now.
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
    void wake();

    /// Axes and dead man belong together: a mouse that has fallen silent holds no dead man and is not
    /// deflected.
    [[nodiscard]] Mouse3dReading reading() const;
    [[nodiscard]] core::DeviceStatus status() const { return m_published.get(); }
    [[nodiscard]] std::string name() const { return m_name.get(); }
    /// Motion that counts: nothing without the dead-man button, nor from a cap that has fallen silent.
    [[nodiscard]] SixAxes motion() const;

private:
    using Lock = std::unique_lock<std::mutex>;

    [[nodiscard]] bool connect(Lock& lock, const std::stop_token& stop);
    void readReports(const std::stop_token& stop);
    void take(std::span<const std::uint8_t> report);
    [[nodiscard]] bool isSilent(const Mouse3dReading& reading) const;
    void letGoIfSilent();
    void forget();
    void setState(core::DeviceState state, std::string message = {});
    void publish();
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }

    HidInputOpener m_opener;
    Mouse3dConfig m_config;
    core::Wakeup* m_consumer = nullptr;
    std::mutex m_mutex; ///< of the condition only; the rest is the worker's
    std::condition_variable m_condition;
    std::unique_ptr<HidInput> m_input;
    RawAxes m_raw;
    bool m_deadManSeenReleased = false; ///< since the mouse was connected, or fell silent
    Mouse3dReading m_now;
    core::RateMeter m_rate;
    core::DeviceStatus m_status;
    core::LatestCopy<Mouse3dReading> m_reading;
    core::LatestCopy<core::DeviceStatus> m_published;
    core::LatestCopy<std::string> m_name;
};

} // namespace teleta::mouse3d
