// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/wakeup.h"

#include <stop_token>
#include <thread>

namespace teleta::core {

/// The thread of a device's worker. start() calls worker.open(consumer) on the caller's thread and then
/// worker.run(stop) on its own; stop(), which the destructor calls, ends the worker's wait by worker.wake()
/// and joins. Both are idempotent. Declare it after the worker, which must outlive it. Thread: one at a time.
template <typename Worker>
class DeviceThread {
public:
    explicit DeviceThread(Worker& worker)
        : m_worker(worker) {}
    ~DeviceThread() { stop(); }
    DeviceThread(const DeviceThread&) = delete;
    DeviceThread& operator=(const DeviceThread&) = delete;

    void start(Wakeup& consumer) {
        if (m_thread.joinable())
            return;
        m_worker.open(consumer);
        m_thread = std::jthread([this](const std::stop_token& stop) { m_worker.run(stop); });
    }

    void stop() {
        if (!m_thread.joinable())
            return;
        m_thread.request_stop();
        m_worker.wake();
        m_thread.join();
    }

private:
    Worker& m_worker;
    std::jthread m_thread;
};

} // namespace teleta::core
