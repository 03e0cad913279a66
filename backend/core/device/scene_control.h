// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace teleta::core {

/// What an operator asks of a simulated scene that has no arm with a program of its own: to hold it, to let
/// it go on, to begin it anew. STOP holds it as well, and it stays held when STOP is released: nothing moves
/// on unless somebody asks for it. Thread: takeRestart() by the source's worker, the rest by any; lock-free.
class SceneControl {
public:
    void setRunning(bool running) { m_held.store(!running, std::memory_order_release); }
    /// The same scene from its beginning; one that is held runs then. Under STOP nothing begins.
    void restart() {
        setRunning(true);
        m_restartWish.store(true, std::memory_order_release);
    }
    [[nodiscard]] bool isHeld() const { return m_held.load(std::memory_order_acquire); }

    /// stopped: STOP is engaged; the wish is forgotten then.
    [[nodiscard]] bool takeRestart(bool stopped) {
        return m_restartWish.exchange(false, std::memory_order_acq_rel) && !stopped;
    }

private:
    std::atomic<bool> m_held{false};
    std::atomic<bool> m_restartWish{false};
};

} // namespace teleta::core
