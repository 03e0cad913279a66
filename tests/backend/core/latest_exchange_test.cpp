// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/threads/latest_exchange.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>

using teleta::core::LatestExchange;

TEST(LatestExchange, givesTheNewestValueOnceAndCountsPublications) {
    LatestExchange<int> exchange;
    EXPECT_FALSE(exchange.update());
    EXPECT_EQ(exchange.generation(), 0U);

    for (int value = 1; value <= 5; ++value) {
        exchange.back() = value;
        exchange.publish();
    }
    EXPECT_TRUE(exchange.update());
    EXPECT_EQ(exchange.front(), 5);
    EXPECT_EQ(exchange.generation(), 5U);
    EXPECT_FALSE(exchange.update());
    EXPECT_EQ(exchange.front(), 5);
}

TEST(LatestExchange, neverShowsATornValueAndNeverGoesBack) {
    struct Value {
        std::array<std::uint64_t, 64> words{};
    };
    LatestExchange<Value> exchange;
    constexpr std::uint64_t kLast = 100'000;
    std::jthread writer([&] {
        for (std::uint64_t count = 1; count <= kLast; ++count) {
            exchange.back().words.fill(count);
            exchange.publish();
        }
    });

    bool whole = true;
    bool forward = true;
    std::uint64_t seen = 0;
    while (seen < kLast) {
        if (!exchange.update()) {
            std::this_thread::yield();
            continue;
        }
        const std::uint64_t first = exchange.front().words.front();
        for (const std::uint64_t word : exchange.front().words)
            whole = whole && word == first;
        forward = forward && first > seen && exchange.generation() == first;
        seen = first;
    }
    EXPECT_TRUE(whole);
    EXPECT_TRUE(forward);
}
