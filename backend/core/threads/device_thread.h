// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/wakeup.h"

#include <stop_token>
#include <thread>

namespace teleta::core {

/// The thread on which a device's worker runs: worker.open(consumer) on the caller's, then worker.run(stop)
/// until stop(), which ends its wait by worker.wake(). Starting what runs, and stopping what does not, does
/// nothing. The worker must outlive the thread. Thread: one at a time.
class DeviceThread {
public:
    template <typename Worker>
    void start(Worker& worker, Wakeup& consumer) {
        if (m_thread.joinable())
            return;
        worker.open(consumer);
        m_thread = std::jthread([&worker](const std::stop_token& stop) { worker.run(stop); });
    }

    template <typename Worker>
    void stop(Worker& worker) {
        if (!m_thread.joinable())
            return;
        m_thread.request_stop();
        worker.wake();
        m_thread.join();
    }

private:
    std::jthread m_thread;
};

} // namespace teleta::core
