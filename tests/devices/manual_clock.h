// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"
#include "backend/core/threads/wakeup.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace teleta::test {

/// A clock for one worker that moves only when the test moves it, so that pacing is tested without time
/// passing.
class ManualClock : public core::PacingClock {
public:
    [[nodiscard]] std::int64_t now_ns() const override {
        const std::scoped_lock lock(m_mutex);
        return m_now_ns;
    }

    [[nodiscard]] std::int64_t suspended_ns() const override {
        const std::scoped_lock lock(m_mutex);
        return m_suspended_ns;
    }
    /// As if the machine had slept for so long.
    void suspend(std::int64_t duration_ns) {
        const std::scoped_lock lock(m_mutex);
        m_suspended_ns += duration_ns;
    }

    void waitUntil(std::condition_variable& condition, std::unique_lock<std::mutex>& lock,
                   std::int64_t deadline_ns) override {
        std::unique_lock own(m_mutex);
        if (deadline_ns <= m_now_ns)
            return;
        m_deadline_ns = deadline_ns;
        m_condition = &condition;
        m_workerMutex = lock.mutex();
        m_parked = true;
        m_changed.notify_all();
        own.unlock();
        condition.wait(lock);
        own.lock();
        m_parked = false;
    }

    /// Moves on by so much, then waits until the worker has done all that is due and waits for a later time.
    void advance(std::int64_t step_ns) {
        std::unique_lock own(m_mutex);
        m_now_ns += step_ns;
        while (!m_parked || m_deadline_ns <= m_now_ns) {
            if (m_parked) {
                m_parked = false;
                std::mutex& workerMutex = *m_workerMutex;
                std::condition_variable& condition = *m_condition;
                own.unlock();
                // The worker holds its mutex until it really waits.
                { const std::scoped_lock worker(workerMutex); }
                condition.notify_all();
                own.lock();
            } else if (m_changed.wait_for(own, std::chrono::seconds(20)) == std::cv_status::timeout) {
                ADD_FAILURE() << "the worker does not come to rest";
                return;
            }
        }
    }

    void settle() { advance(0); }

    /// Whether the worker comes to wait for just this time.
    [[nodiscard]] bool comesToWaitFor(std::int64_t deadline_ns) {
        std::unique_lock own(m_mutex);
        return m_changed.wait_for(own, std::chrono::seconds(20),
                                  [&] { return m_parked && m_deadline_ns == deadline_ns; });
    }

    /// Moves on by so much and wakes a worker that waits; for one that goes on to wait for something else.
    void advanceAlone(std::int64_t step_ns) {
        std::unique_lock own(m_mutex);
        m_now_ns += step_ns;
        if (!m_parked || m_deadline_ns > m_now_ns)
            return;
        m_parked = false;
        std::mutex& workerMutex = *m_workerMutex;
        std::condition_variable& condition = *m_condition;
        own.unlock();
        { const std::scoped_lock worker(workerMutex); }
        condition.notify_all();
    }

private:
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::int64_t m_now_ns = 1'000'000'000'000;
    std::int64_t m_suspended_ns = 0;
    bool m_parked = false;
    std::int64_t m_deadline_ns = 0;
    std::condition_variable* m_condition = nullptr;
    std::mutex* m_workerMutex = nullptr;
};

/// Waits, notified by a source, until a condition holds; false when it does not come to hold.
template <typename Condition>
[[nodiscard]] bool eventually(core::Wakeup& wakeup, const Condition& condition) {
    for (int i = 0; i < 2000; ++i) {
        if (condition())
            return true;
        wakeup.waitFor(std::chrono::milliseconds(10));
    }
    return condition();
}

} // namespace teleta::test
