// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/device_thread.h"
#include "devices/mouse3d/mouse3d_worker.h"

#include <string>
#include <utility>

namespace teleta::mouse3d {

/// A six-axis mouse with a dead-man button: facade over a worker thread.
///   connecting -> live; unplugged: lost -> reconnecting -> live; stop(): closed
/// Thread: start and stop from one controlling thread; the rest by any.
class Mouse3d {
public:
    /// opener: by default the first mouse that hidapi finds.
    explicit Mouse3d(Mouse3dConfig config = {}, HidInputOpener opener = openFirstMouse)
        : m_worker(std::move(opener), std::move(config)) {}
    Mouse3d(const Mouse3d&) = delete;
    Mouse3d& operator=(const Mouse3d&) = delete;

    /// Starts the worker, which notifies the consumer of reports and changes of state.
    void start(core::Wakeup& consumer) { m_thread.start(consumer); }
    /// Ends the worker and waits for it, at most readTimeout_ms. Idempotent.
    void stop() { m_thread.stop(); }

    /// Motion to apply now: zero without the dead-man button, without a mouse, and when the reports of a
    /// deflected cap stop; the button has to be pressed again then.
    [[nodiscard]] SixAxes motion() const { return m_worker.motion(); }
    [[nodiscard]] Mouse3dReading reading() const { return m_worker.reading(); }
    [[nodiscard]] core::DeviceStatus status() const { return m_worker.status(); }
    /// Of the mouse that is, or was last, connected; empty before that.
    [[nodiscard]] std::string name() const { return m_worker.name(); }

private:
    Mouse3dWorker m_worker;
    core::DeviceThread<Mouse3dWorker> m_thread{m_worker};
};

} // namespace teleta::mouse3d
