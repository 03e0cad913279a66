// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/camera_outlet.h"
#include "backend/core/device/joint_outlet.h"
#include "backend/core/device/status_publisher.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <utility>

using namespace teleta::core;
using namespace std::chrono_literals;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;

class StatusPublisherTest : public testing::Test {
protected:
    StatusPublisherTest() { m_publisher.open(m_consumer, 100); }

    void receive(std::int64_t time_ns) {
        m_publisher.receive(DeviceState::live, time_ns);
        m_publisher.publishAndWake();
    }
    [[nodiscard]] bool woke() { return m_consumer.waitFor(0s); }

    Wakeup m_consumer;
    StatusPublisher m_publisher;
};

} // namespace

TEST_F(StatusPublisherTest, startsOverWhenItIsOpened) {
    EXPECT_TRUE(woke());
    receive(200);
    m_publisher.lose(3);
    m_publisher.open(m_consumer, 300);
    const DeviceStatus status = m_publisher.status();
    EXPECT_EQ(status.state, DeviceState::connecting);
    EXPECT_EQ(status.since_ns, 300);
    EXPECT_EQ(status.framesRead, 0U);
    EXPECT_EQ(status.framesLost, 0U);
    EXPECT_EQ(status.lastData_ns, 0);
}

TEST_F(StatusPublisherTest, aNewMessageForTheSameStateKeepsTheTimeAtWhichItBegan) {
    m_publisher.setState(DeviceState::lost, 200, "unplugged");
    m_publisher.setState(DeviceState::lost, 300, "busy");
    EXPECT_EQ(m_publisher.status().since_ns, 200);
    EXPECT_EQ(m_publisher.status().message, "busy");
    m_publisher.setState(DeviceState::reconnecting, 400, "busy");
    EXPECT_EQ(m_publisher.status().since_ns, 400);
}

TEST_F(StatusPublisherTest, wakesTheConsumerOnlyWhenStateOrMessageChanges) {
    m_publisher.setState(DeviceState::lost, 200, "unplugged");
    EXPECT_TRUE(woke());
    m_publisher.setState(DeviceState::lost, 300, "unplugged");
    EXPECT_FALSE(woke());
    m_publisher.setState(DeviceState::lost, 300, "busy");
    EXPECT_TRUE(woke());
}

TEST_F(StatusPublisherTest, measuresTheRateAnewAfterEveryStateOtherThanLive) {
    for (int i = 0; i < 5; ++i)
        receive((1000 + 10 * i) * kMs_ns);
    EXPECT_NEAR(m_publisher.status().rate_Hz, 100.0, 1e-9);
    m_publisher.setState(DeviceState::live, 1041 * kMs_ns, "a reading failed");
    EXPECT_NEAR(m_publisher.status().rate_Hz, 100.0, 1e-9) << "it is live as before";
    m_publisher.setState(DeviceState::stale, 1100 * kMs_ns);
    EXPECT_EQ(m_publisher.status().rate_Hz, 0.0);
    receive(1200 * kMs_ns);
    EXPECT_EQ(m_publisher.status().rate_Hz, 0.0) << "the gap does not count";
    receive(1250 * kMs_ns);
    EXPECT_NEAR(m_publisher.status().rate_Hz, 20.0, 1e-9);
}

TEST_F(StatusPublisherTest, receivedDataProvesTheStateAndClearsTheMessage) {
    const std::array<std::int64_t, 3> times_ns{200, 210, 220};
    EXPECT_TRUE(m_publisher.receive(DeviceState::live, times_ns));
    m_publisher.publish();
    EXPECT_EQ(m_publisher.status().since_ns, 220) << "as of the newest frame";
    EXPECT_EQ(m_publisher.status().lastData_ns, 220);
    EXPECT_EQ(m_publisher.status().framesRead, 3U);
    m_publisher.setState(DeviceState::live, 230, "a reading failed");
    EXPECT_FALSE(m_publisher.receive(DeviceState::live, 240));
    m_publisher.publish();
    EXPECT_EQ(m_publisher.status().message, "");
    EXPECT_EQ(m_publisher.status().since_ns, 220);
}

TEST_F(StatusPublisherTest, countsLossesOneByOneOrInTotal) {
    m_publisher.lose(2);
    m_publisher.lose(3);
    m_publisher.publish();
    EXPECT_EQ(m_publisher.status().framesLost, 5U);
    m_publisher.setLost(7);
    EXPECT_EQ(m_publisher.status().framesLost, 5U) << "not published yet";
    m_publisher.publish();
    EXPECT_EQ(m_publisher.status().framesLost, 7U);
}

JointSample sampleAt(std::int64_t time_ns) {
    JointSample sample;
    sample.time_ns = time_ns;
    return sample;
}

TEST(JointOutlet, wakesTheConsumerWithTheFirstSampleAndThenOncePerBatch) {
    JointOutlet outlet(16, 3);
    Wakeup consumer;
    outlet.open(consumer, 0);
    EXPECT_TRUE(consumer.waitFor(0s));
    const auto wakes = [&](std::int64_t time_ns) {
        outlet.deliver(sampleAt(time_ns));
        return consumer.waitFor(0s);
    };
    EXPECT_TRUE(wakes(10));
    EXPECT_FALSE(wakes(20));
    EXPECT_FALSE(wakes(30));
    EXPECT_TRUE(wakes(40));
    EXPECT_FALSE(wakes(50));
    outlet.flush();
    EXPECT_TRUE(consumer.waitFor(0s));
    outlet.flush();
    EXPECT_FALSE(consumer.waitFor(0s)) << "there was nothing left";
}

TEST(JointOutlet, wakesTheConsumerWithEachSampleWhenItIsAskedTo) {
    JointOutlet outlet(16, 3);
    Wakeup consumer;
    outlet.open(consumer, 0);
    outlet.deliver(sampleAt(10));
    EXPECT_TRUE(consumer.waitFor(0s));
    const auto wakes = [&](std::int64_t time_ns) {
        outlet.deliver(sampleAt(time_ns));
        return consumer.waitFor(0s);
    };
    EXPECT_FALSE(wakes(20));
    outlet.wakeAtEachSample(true);
    EXPECT_TRUE(wakes(30)) << "with what waited for its batch";
    EXPECT_TRUE(wakes(40));
    outlet.wakeAtEachSample(false);
    EXPECT_FALSE(wakes(50));
    EXPECT_FALSE(wakes(60));
    EXPECT_TRUE(wakes(70));
}

TEST(JointOutlet, countsWhatAFullQueueLoses) {
    JointOutlet outlet(2, 1);
    Wakeup consumer;
    outlet.open(consumer, 0);
    for (int i = 1; i <= 5; ++i)
        outlet.deliver(sampleAt(10 * i));
    outlet.lose(1);
    EXPECT_EQ(outlet.status().framesRead, 5U);
    EXPECT_EQ(outlet.status().framesLost, 4U);
    EXPECT_EQ(outlet.lastData_ns(), 50);
}

TEST(CameraOutlet, keepsTheNewestFramesAndTellsHowManyWereDropped) {
    CameraOutlet outlet(2);
    Wakeup consumer;
    outlet.open(consumer, 0);
    EXPECT_FALSE(outlet.isFull());
    for (std::uint64_t i = 1; i <= 3; ++i) {
        CameraFrame frame;
        frame.time_ns = static_cast<std::int64_t>(10 * i);
        frame.number = i;
        outlet.deliver(std::move(frame));
    }
    EXPECT_TRUE(outlet.isFull());
    EXPECT_EQ(outlet.framesRead(), 3U);
    EXPECT_EQ(outlet.state(), DeviceState::live);
    EXPECT_EQ(outlet.status().since_ns, 10);
    CameraFrame frame;
    ASSERT_TRUE(outlet.frames().pop(frame));
    EXPECT_EQ(frame.number, 2U);
    EXPECT_EQ(frame.passedOver, 1U);
}
