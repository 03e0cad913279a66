// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace teleta::core {

/// Lets the operator hold, resume and restart a simulated scene without an arm program. STOP holds the scene
/// of an array as well, and it stays held when STOP is released. In the scene of a camera the world goes on,
/// and its arm stands still until it may react again. Thread: takeRestart() from the source's worker, the
/// rest from any; lock-free.
class SceneControl {
public:
    void setRunning(bool running) { m_held.store(!running, std::memory_order_release); }
    /// Restarts the scene and lets it run. Ignored under STOP.
    void restart() {
        setRunning(true);
        m_restartWish.store(true, std::memory_order_release);
    }
    [[nodiscard]] bool isHeld() const { return m_held.load(std::memory_order_acquire); }

    /// Whether to restart now. stopped: STOP is engaged, which discards a requested restart.
    [[nodiscard]] bool takeRestart(bool stopped) {
        return m_restartWish.exchange(false, std::memory_order_acq_rel) && !stopped;
    }

private:
    std::atomic<bool> m_held{false};
    std::atomic<bool> m_restartWish{false};
};

} // namespace teleta::core
