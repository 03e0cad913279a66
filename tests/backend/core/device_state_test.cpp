// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/device_state.h"

#include <gtest/gtest.h>

#include <limits>

using teleta::core::DeviceState;
using teleta::core::observedState;
using teleta::core::staleAfter_ns;

TEST(DeviceState, aLiveDeviceWhoseDataIsOldIsSeenAsStale) {
    constexpr std::int64_t kLimit_ns = 100;
    EXPECT_EQ(observedState(DeviceState::live, 1000, 1100, kLimit_ns), DeviceState::live);
    EXPECT_EQ(observedState(DeviceState::live, 1000, 1101, kLimit_ns), DeviceState::stale);
    EXPECT_EQ(observedState(DeviceState::paused, 1000, 9999, kLimit_ns), DeviceState::paused);
    EXPECT_EQ(observedState(DeviceState::lost, 1000, 9999, kLimit_ns), DeviceState::lost);
}

TEST(DeviceState, theStaleLimitFollowsTheRateWithinBounds) {
    EXPECT_EQ(staleAfter_ns(200.0), 100'000'000);
    EXPECT_EQ(staleAfter_ns(10.0), 500'000'000);
    EXPECT_EQ(staleAfter_ns(0.0), 1'000'000'000);
    EXPECT_EQ(staleAfter_ns(-1.0), 1'000'000'000);
    EXPECT_EQ(staleAfter_ns(std::numeric_limits<double>::quiet_NaN()), 1'000'000'000);
    EXPECT_EQ(staleAfter_ns(1e-300), 60'000'000'000);
}
