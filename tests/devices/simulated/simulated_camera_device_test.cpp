// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_camera_device.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

using namespace teleta;
using core::CameraFrame;
using core::DeviceState;
using simulated::SimulatedCameraConfig;
using simulated::SimulatedCameraDevice;
using simulated::SimulatedFaults;

namespace {

constexpr std::int64_t kFrame_ns = 25'000'000;

/// Frames of one pixel that count up; the world begins anew at the tenth.
class CountingGenerator : public core::CameraGenerator {
public:
    explicit CountingGenerator(std::atomic<bool>& held)
        : m_held(held) {}
    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    bool next(core::GreyImage& image, bool held) override {
        m_held = held;
        image.pixels = std::make_shared<std::uint8_t>(static_cast<std::uint8_t>(m_frames));
        image.width_px = image.height_px = 1;
        return ++m_frames == 10;
    }
    [[nodiscard]] double time_s() const override { return m_frames / 40.0; }

private:
    std::atomic<bool>& m_held;
    core::CameraDescription m_description{.name = "counting", .nominalRate_Hz = 40.0, .simulated = true};
    int m_frames = 0;
};

class SimulatedCameraTest : public testing::Test {
protected:
    void open(SimulatedCameraConfig config = {}) {
        config.clock = m_clock;
        m_device = std::make_unique<SimulatedCameraDevice>(std::make_unique<CountingGenerator>(m_held),
                                                           m_stop, std::move(config));
        m_device->start(m_wakeup);
        m_clock->settle();
    }
    std::vector<CameraFrame> take() {
        std::vector<CameraFrame> frames;
        CameraFrame frame;
        while (m_device->pop(frame))
            frames.push_back(frame);
        return frames;
    }
    void TearDown() override {
        if (m_device)
            m_device->stop();
    }

    std::shared_ptr<test::ManualClock> m_clock = std::make_shared<test::ManualClock>();
    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    std::atomic<bool> m_held{false};
    std::unique_ptr<SimulatedCameraDevice> m_device;
};

} // namespace

TEST_F(SimulatedCameraTest, givesOneFrameAPeriodStampedWhenItWasRead) {
    open();
    EXPECT_EQ(m_device->status().state, DeviceState::connecting);
    EXPECT_TRUE(take().empty());
    m_clock->advance(kFrame_ns);
    m_clock->advance(kFrame_ns);
    const auto frames = take();
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(*frames[1].image.pixels, 1);
    EXPECT_EQ(frames[1].number, 1U);
    EXPECT_EQ(frames[1].time_ns - frames[0].time_ns, kFrame_ns);
    EXPECT_DOUBLE_EQ(frames[1].capture_s, 2.0 / 40.0);
    EXPECT_EQ(m_device->status().state, DeviceState::live);
    EXPECT_DOUBLE_EQ(m_device->status().rate_Hz, 40.0);
}

TEST_F(SimulatedCameraTest, saysWhenTheWorldBeginsAnew) {
    open({.queueFrames = 16});
    for (int i = 0; i < 12; ++i)
        m_clock->advance(kFrame_ns);
    const auto frames = take();
    ASSERT_EQ(frames.size(), 12U);
    for (std::size_t i = 0; i < frames.size(); ++i)
        EXPECT_EQ(frames[i].discontinuity, i == 9) << i;
}

TEST_F(SimulatedCameraTest, isHeldWhileStopIsEngagedAndGoesOnGivingFrames) {
    open();
    m_clock->advance(kFrame_ns);
    EXPECT_FALSE(m_held);
    m_stop.engage();
    m_clock->advance(kFrame_ns);
    EXPECT_TRUE(m_held);
    EXPECT_EQ(take().size(), 2U);
    m_stop.release();
    m_clock->advance(kFrame_ns);
    EXPECT_FALSE(m_held);
}

TEST_F(SimulatedCameraTest, isLostWhenUnpluggedAndComesBackByItself) {
    open();
    m_clock->advance(kFrame_ns);
    m_device->setFaults({.unplugged = true});
    const auto comesTo = [&](DeviceState state) {
        return test::eventually(m_wakeup, [&] { return m_device->status().state == state; });
    };
    ASSERT_TRUE(comesTo(DeviceState::lost));
    m_clock->settle();
    EXPECT_EQ(m_device->status().message, "The camera was unplugged.");
    m_clock->advance(100'000'000);
    EXPECT_EQ(m_device->status().state, DeviceState::reconnecting);
    m_device->setFaults({});
    m_clock->advance(200'000'000);
    ASSERT_TRUE(comesTo(DeviceState::connecting));
    m_clock->settle();
    m_clock->advance(kFrame_ns);
    const auto frames = take();
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_FALSE(frames[0].discontinuity);
    EXPECT_TRUE(frames[1].discontinuity);
    EXPECT_EQ(m_device->status().state, DeviceState::live);
}

TEST_F(SimulatedCameraTest, countsWhatTheLinkLosesAndWhatArrivesDamaged) {
    SimulatedCameraConfig config;
    config.queueFrames = 256;
    config.faults.dropShare = 0.25;
    config.undecodableShare = 0.25;
    open(std::move(config));
    for (int i = 0; i < 200; ++i)
        m_clock->advance(kFrame_ns);
    const auto frames = take();
    const auto damaged = static_cast<std::uint64_t>(
        std::ranges::count_if(frames, [](const CameraFrame& frame) { return frame.image.isEmpty(); }));
    EXPECT_LT(frames.size(), 180U);
    EXPECT_GT(damaged, 10U);
    EXPECT_EQ(m_device->status().framesLost, 200 - frames.size() + damaged);
    EXPECT_EQ(frames.back().number - frames.front().number >= frames.size(), true) << "gaps in the numbers";
}

TEST_F(SimulatedCameraTest, doesNotMakeUpForTimeThatItWasLate) {
    open();
    m_clock->advance(10 * kFrame_ns);
    EXPECT_EQ(take().size(), 2U) << "the one that was due, and one at once";
    m_clock->advance(kFrame_ns);
    EXPECT_EQ(take().size(), 1U);
}

TEST_F(SimulatedCameraTest, keepsTheNewestFramesOfAQueueThatNobodyTakesAndTellsHowManyWentBefore) {
    open({.queueFrames = 4});
    for (int i = 0; i < 12; ++i)
        m_clock->advance(kFrame_ns);
    const auto frames = take();
    ASSERT_EQ(frames.size(), 4U);
    EXPECT_EQ(frames.front().number, 8U);
    EXPECT_EQ(frames.front().passedOver, 8U);
    EXPECT_FALSE(frames.front().discontinuity);
    EXPECT_TRUE(frames[1].discontinuity) << "the tenth begins anew";
    EXPECT_EQ(frames.back().number, 11U);
    EXPECT_EQ(frames.back().passedOver, 0U);
    EXPECT_EQ(m_device->status().framesLost, 0U) << "the link lost none";
    for (int i = 0; i < 4; ++i)
        m_clock->advance(kFrame_ns);
    EXPECT_EQ(take().front().passedOver, 0U);
}

TEST_F(SimulatedCameraTest, tellsOfABreakThatAFullQueueDropped) {
    open({.queueFrames = 2});
    for (int i = 0; i < 14; ++i)
        m_clock->advance(kFrame_ns);
    const auto frames = take();
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_TRUE(frames.front().discontinuity) << "that of the tenth";
    EXPECT_FALSE(frames.back().discontinuity);
}
