// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/source_outlet.h"

#include <gtest/gtest.h>

#include <chrono>

using namespace teleta::core;
using namespace std::chrono_literals;

namespace {

SampleBlock blockOf(std::vector<std::int64_t> time_ns) {
    SampleBlock block;
    block.channels = 1;
    block.sourceTime_s.assign(time_ns.size(), 0.0);
    block.values.assign(time_ns.size(), 0.0F);
    block.time_ns = std::move(time_ns);
    return block;
}

} // namespace

TEST(SourceOutlet, numbersFramesSoThatEveryLossIsAGap) {
    SourceOutlet outlet(2);
    Wakeup consumer;
    outlet.open(consumer, 100);
    outlet.deliver(blockOf({110, 120}), DeviceState::live);
    outlet.lose(3);
    outlet.deliver(blockOf({130}), DeviceState::live);
    outlet.deliver(blockOf({140, 150}), DeviceState::live); // does not fit
    SampleBlock block;
    ASSERT_TRUE(outlet.blocks().pop(block));
    EXPECT_EQ(block.firstFrame, 0U);
    ASSERT_TRUE(outlet.blocks().pop(block));
    EXPECT_EQ(block.firstFrame, 5U);
    outlet.deliver(blockOf({160}), DeviceState::live);
    ASSERT_TRUE(outlet.blocks().pop(block));
    EXPECT_EQ(block.firstFrame, 8U);
    const DeviceStatus status = outlet.status();
    EXPECT_EQ(status.framesRead, 6U);
    EXPECT_EQ(status.framesLost, 5U);
    EXPECT_EQ(status.lastData_ns, 160);
}

TEST(SourceOutlet, leavesABlockThatDoesNotFitWithAWorkerThatCanWait) {
    SourceOutlet outlet(1);
    Wakeup consumer;
    outlet.open(consumer, 0);
    SampleBlock first = blockOf({10});
    SampleBlock second = blockOf({20, 30});
    EXPECT_TRUE(outlet.tryDeliver(first, DeviceState::live));
    EXPECT_FALSE(outlet.tryDeliver(second, DeviceState::live));
    EXPECT_EQ(second.frames(), 2U);
    EXPECT_EQ(outlet.status().framesRead, 1U);
    EXPECT_EQ(outlet.status().framesLost, 0U);
    SampleBlock block;
    ASSERT_TRUE(outlet.blocks().pop(block));
    EXPECT_TRUE(outlet.tryDeliver(second, DeviceState::live));
    ASSERT_TRUE(outlet.blocks().pop(block));
    EXPECT_EQ(block.firstFrame, 1U);
}

TEST(SourceOutlet, publishesStatesAndWakesTheConsumer) {
    SourceOutlet outlet(4);
    Wakeup consumer;
    EXPECT_EQ(outlet.status().state, DeviceState::closed);
    outlet.open(consumer, 100);
    EXPECT_EQ(outlet.status().state, DeviceState::connecting);
    EXPECT_EQ(outlet.status().since_ns, 100);
    EXPECT_TRUE(consumer.waitFor(0s));
    outlet.deliver(blockOf({1'000'000'000, 1'010'000'000}), DeviceState::live);
    EXPECT_TRUE(consumer.waitFor(0s));
    EXPECT_EQ(outlet.status().since_ns, 1'010'000'000);
    EXPECT_NEAR(outlet.status().rate_Hz, 100.0, 1e-9);
    outlet.setState(DeviceState::lost, 2'000'000'000, "why");
    EXPECT_TRUE(consumer.waitFor(0s));
    EXPECT_EQ(outlet.status().message, "why");
    EXPECT_EQ(outlet.status().rate_Hz, 0.0);
    outlet.setState(DeviceState::lost, 3'000'000'000, "why");
    EXPECT_EQ(outlet.status().since_ns, 2'000'000'000) << "the same state again changes nothing";
    EXPECT_FALSE(consumer.waitFor(0s));
}

TEST(SourceOutlet, isAsFreshAsWhatArrivesThoughItWasReadLongAgo) {
    SourceOutlet outlet(4);
    Wakeup consumer;
    outlet.open(consumer, 0);
    for (std::int64_t i = 0; i < 4; ++i)
        outlet.deliver(blockOf({10'000'000 * i}), DeviceState::live, 1'000'000'000 + 20'000'000 * i);
    EXPECT_EQ(outlet.status().lastData_ns, 1'060'000'000);
    EXPECT_EQ(outlet.status().since_ns, 1'000'000'000);
    EXPECT_NEAR(outlet.status().rate_Hz, 50.0, 1e-9);
    SampleBlock block;
    ASSERT_TRUE(outlet.blocks().pop(block));
    EXPECT_EQ(block.time_ns.front(), 0);
}

TEST(SourceOutlet, countsEachStreamAnew) {
    SourceOutlet outlet(1);
    Wakeup consumer;
    outlet.open(consumer, 0);
    outlet.deliver(blockOf({1}), DeviceState::live);
    outlet.deliver(blockOf({2}), DeviceState::live);
    EXPECT_EQ(outlet.status().framesLost, 1U);
    outlet.open(consumer, 10);
    EXPECT_EQ(outlet.status().framesLost, 0U);
    EXPECT_EQ(outlet.status().framesRead, 0U);
}
