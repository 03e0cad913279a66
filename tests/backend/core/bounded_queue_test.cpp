// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/wakeup.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

using teleta::core::BoundedQueue;
using teleta::core::Wakeup;
using namespace std::chrono_literals;

TEST(BoundedQueue, countsWhatItCannotHoldAndKeepsTheRestInOrder) {
    BoundedQueue<int> queue(3);
    for (int value = 0; value < 5; ++value)
        queue.push(int(value), 10);
    EXPECT_EQ(queue.overflow(), 20U);

    int value = -1;
    for (int expected = 0; expected < 3; ++expected) {
        ASSERT_TRUE(queue.pop(value));
        EXPECT_EQ(value, expected);
    }
    EXPECT_FALSE(queue.pop(value));
}

TEST(BoundedQueue, leavesAnItemThatDoesNotFitWithAProducerThatCanWait) {
    BoundedQueue<std::vector<int>> queue(1);
    std::vector<int> first{1};
    std::vector<int> second{2};
    EXPECT_TRUE(queue.tryPush(first));
    EXPECT_FALSE(queue.tryPush(second));
    EXPECT_EQ(second, std::vector<int>{2});
    EXPECT_EQ(queue.overflow(), 0U);
    std::vector<int> item;
    ASSERT_TRUE(queue.pop(item));
    EXPECT_EQ(item, std::vector<int>{1});
    EXPECT_TRUE(queue.tryPush(second));
}

TEST(BoundedQueue, accountsForEveryItemBetweenTwoThreads) {
    constexpr int kItems = 200'000;
    BoundedQueue<std::vector<int>> queue(64);
    Wakeup wakeup;
    std::jthread producer([&] {
        for (int value = 0; value < kItems; ++value) {
            queue.push({value});
            wakeup.notify();
        }
        while (!queue.push({-1}))
            std::this_thread::yield();
        wakeup.notify();
    });

    int received = 0;
    int last = -1;
    bool ordered = true;
    for (bool open = true; open;) {
        wakeup.waitFor(1s);
        std::vector<int> item;
        while (queue.pop(item)) {
            if (item.front() < 0) {
                open = false;
                break;
            }
            ordered = ordered && item.front() > last;
            last = item.front();
            ++received;
        }
    }
    producer.join();
    EXPECT_TRUE(ordered);
    // The end mark is pushed until it fits, and each refused try is counted too.
    EXPECT_GE(static_cast<std::uint64_t>(received) + queue.overflow(), static_cast<std::uint64_t>(kItems));
    EXPECT_LE(received, kItems);
    EXPECT_GT(received, 0);
}

TEST(Wakeup, keepsANotificationThatComesBeforeTheWait) {
    Wakeup wakeup;
    EXPECT_FALSE(wakeup.waitFor(1ms));
    wakeup.notify();
    wakeup.notify();
    EXPECT_TRUE(wakeup.waitFor(1ms));
    EXPECT_FALSE(wakeup.waitFor(1ms));
}
