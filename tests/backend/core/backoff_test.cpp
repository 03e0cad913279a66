// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/backoff.h"

#include <gtest/gtest.h>

using teleta::core::Backoff;

TEST(Backoff, doublesTheDelayUpToTheLongestOne) {
    Backoff backoff(100, 700);
    EXPECT_EQ(backoff.next_ns(), 100);
    EXPECT_EQ(backoff.next_ns(), 200);
    EXPECT_EQ(backoff.next_ns(), 400);
    EXPECT_EQ(backoff.next_ns(), 700);
    EXPECT_EQ(backoff.next_ns(), 700);
}

TEST(Backoff, startsOverAfterASuccess) {
    Backoff backoff(100, 700);
    (void)backoff.next_ns();
    (void)backoff.next_ns();
    backoff.reset();
    EXPECT_EQ(backoff.next_ns(), 100);
    EXPECT_EQ(backoff.next_ns(), 200);
}
