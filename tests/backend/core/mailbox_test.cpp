// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/threads/mailbox.h"
#include "backend/core/threads/stop_switch.h"

#include <gtest/gtest.h>

#include <thread>

using teleta::core::Mailbox;
using teleta::core::StopSwitch;

TEST(Mailbox, keepsOnlyTheLatestCommandAndCountsTheReplaced) {
    Mailbox<int> box;
    EXPECT_FALSE(box.take().has_value());
    box.post(1);
    box.post(2);
    box.post(3);
    EXPECT_EQ(box.replaced(), 2U);
    EXPECT_EQ(box.take(), 3);
    EXPECT_FALSE(box.take().has_value());
}

TEST(Mailbox, neverLosesTheLastCommandOfABurst) {
    Mailbox<int> box;
    constexpr int kLast = 100'000;
    std::jthread sender([&] {
        for (int value = 1; value <= kLast; ++value)
            box.post(value);
    });
    int newest = 0;
    bool forward = true;
    while (newest < kLast) {
        if (const auto command = box.take()) {
            forward = forward && *command > newest;
            newest = *command;
        }
    }
    EXPECT_TRUE(forward);
    EXPECT_EQ(newest, kLast);
}

TEST(StopSwitch, staysEngagedSinceTheFirstPressUntilItIsReleased) {
    StopSwitch stop;
    EXPECT_FALSE(stop.engaged());
    stop.engage();
    const auto since_ns = stop.engagedSince_ns();
    stop.engage();
    EXPECT_TRUE(stop.engaged());
    EXPECT_EQ(stop.engagedSince_ns(), since_ns);
    stop.release();
    EXPECT_FALSE(stop.engaged());
    EXPECT_EQ(stop.engagedSince_ns(), 0);
}
