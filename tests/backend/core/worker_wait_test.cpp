// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/steady_time.h"
#include "backend/core/threads/worker_wait.h"

#include <gtest/gtest.h>

#include <thread>

using namespace teleta::core;

TEST(WorkerWait, lastsUntilTheDeadlineHoweverOftenItIsWoken) {
    WorkerWait wait(std::make_shared<PacingClock>());
    std::jthread waker([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            wait.wake();
            std::this_thread::yield();
        }
    });
    const std::int64_t deadline_ns = steadyNow_ns() + 20'000'000;
    EXPECT_TRUE(wait.until(deadline_ns, std::stop_token()));
    EXPECT_GE(steadyNow_ns(), deadline_ns);
}

TEST(WorkerWait, endsWhenStopIsRequested) {
    WorkerWait wait(std::make_shared<PacingClock>());
    std::stop_source stop;
    std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        stop.request_stop();
        wait.wake();
    });
    EXPECT_FALSE(wait.until(PacingClock::kNever_ns, stop.get_token()));
    EXPECT_FALSE(wait.until(0, stop.get_token())) << "also when the deadline has passed";
}
