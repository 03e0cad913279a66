// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/replay/replay_fixture.h"

using namespace teleta;
using core::DeviceState;
using core::PlaybackPosition;
using test::eventually;
using test::kMs_ns;
using test::kUnpaced;
using test::ReceivedFrame;

class ReplayControlTest : public test::ReplayTest {
protected:
    /// Shows the first of so many frames and waits.
    void openPaused(int frames) {
        writeFrames(frames);
        replay::CsvConfig paused = config();
        paused.autoplay = false;
        play(paused);
    }
};

TEST_F(ReplayControlTest, showsTheFirstFrameAndWaits) {
    openPaused(10);
    const std::vector<ReceivedFrame> frames = drain();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].value, 0.0F);
    EXPECT_FALSE(frames[0].discontinuity);
    EXPECT_EQ(m_device->status().state, DeviceState::paused);
    EXPECT_TRUE(m_device->position().paused);
    m_clock->advance(60'000 * kMs_ns);
    EXPECT_TRUE(drain().empty());
}

TEST_F(ReplayControlTest, pausesAndGoesOnWhereItWas) {
    writeFrames(20);
    play(config());
    m_clock->advance(250 * kMs_ns);
    EXPECT_EQ(drain().size(), 3U);
    m_device->pause();
    ASSERT_TRUE(comesTo(DeviceState::paused));
    EXPECT_TRUE(m_device->position().paused);
    EXPECT_EQ(m_device->status().rate_Hz, 0.0);
    m_clock->settle();
    m_clock->advance(60'000 * kMs_ns);
    EXPECT_TRUE(drain().empty());
    m_device->play();
    ASSERT_TRUE(comesTo(DeviceState::live));
    m_clock->settle();
    m_clock->advance(101 * kMs_ns);
    const std::vector<ReceivedFrame> frames = drain();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].value, 3.0F);
    EXPECT_FALSE(frames[0].discontinuity);
    EXPECT_FALSE(m_device->position().paused);
}

TEST_F(ReplayControlTest, stepsForwardAndBack) {
    openPaused(10);
    drain();
    ReceivedFrame frame = shownBy([](auto& device) { device.step(1); });
    EXPECT_EQ(frame.value, 1.0F);
    EXPECT_FALSE(frame.discontinuity) << "the next frame is no jump";
    frame = shownBy([](auto& device) { device.step(1); });
    EXPECT_EQ(frame.value, 2.0F);
    frame = shownBy([](auto& device) { device.step(-1); });
    EXPECT_EQ(frame.value, 1.0F);
    EXPECT_TRUE(frame.discontinuity);
    EXPECT_NEAR(m_device->position().time_s, 0.1, 1e-9);
    frame = shownBy([](auto& device) { device.step(5); });
    EXPECT_EQ(frame.value, 6.0F);
    EXPECT_TRUE(frame.discontinuity);
    EXPECT_EQ(shownBy([](auto& device) { device.step(1); }).value, 7.0F);
    EXPECT_EQ(shownBy([](auto& device) { device.step(-100); }).value, 0.0F) << "not before the first";
    EXPECT_EQ(shownBy([](auto& device) { device.step(100); }).value, 9.0F) << "not behind the last";
    EXPECT_EQ(shownBy([](auto& device) { device.step(-2); }).value, 7.0F);
    EXPECT_EQ(m_device->status().state, DeviceState::paused);
    EXPECT_EQ(m_device->position().frame, 7U);
}

TEST_F(ReplayControlTest, pausesWhenItSteps) {
    writeFrames(20);
    play(config());
    m_clock->advance(250 * kMs_ns);
    drain();
    EXPECT_EQ(shownBy([](auto& device) { device.step(1); }).value, 3.0F);
    EXPECT_EQ(m_device->status().state, DeviceState::paused);
    m_clock->settle();
    m_clock->advance(60'000 * kMs_ns);
    EXPECT_TRUE(drain().empty());
}

TEST_F(ReplayControlTest, seeksWhilePausedAndShowsTheFrame) {
    openPaused(100);
    drain();
    ReceivedFrame frame = shownBy([](auto& device) { device.seek(5.04); });
    EXPECT_EQ(frame.value, 51.0F) << "the first frame at or after the time";
    EXPECT_TRUE(frame.discontinuity);
    EXPECT_NEAR(m_device->position().time_s, 5.1, 1e-9);
    EXPECT_EQ(shownBy([](auto& device) { device.seek(0.0); }).value, 0.0F);
    EXPECT_EQ(shownBy([](auto& device) { device.seek(1e9); }).value, 99.0F);
    EXPECT_EQ(shownBy([](auto& device) { device.seek(-1e9); }).value, 0.0F);
    EXPECT_EQ(m_device->status().state, DeviceState::paused);
}

TEST_F(ReplayControlTest, comesBackToEveryPositionThatItReported) {
    openPaused(100);
    drain();
    for (const int frame : {1, 17, 33, 64, 98}) {
        EXPECT_EQ(shownBy([&](auto& device) { device.seek(frame * 0.1 - 0.05); }).value,
                  static_cast<float>(frame));
        const double time_s = m_device->position().time_s;
        shownBy([](auto& device) { device.seek(1e9); });
        EXPECT_EQ(shownBy([&](auto& device) { device.seek(time_s); }).value, static_cast<float>(frame));
    }
}

TEST_F(ReplayControlTest, goesOnPlayingFromWhereItWasSent) {
    writeFrames(100);
    play(config());
    m_clock->advance(150 * kMs_ns);
    EXPECT_EQ(drain().size(), 2U);
    EXPECT_EQ(shownBy([](auto& device) { device.seek(5.0); }).value, 50.0F);
    m_clock->settle();
    m_clock->advance(101 * kMs_ns);
    const std::vector<ReceivedFrame> frames = drain();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].value, 51.0F);
    EXPECT_FALSE(frames[0].discontinuity);
    EXPECT_EQ(m_device->status().state, DeviceState::live);
}

TEST_F(ReplayControlTest, seeksAndStepsInAFixedRate) {
    writeFrames(1000);
    replay::CsvConfig fixed = config();
    fixed.rate_Hz = 30.0;
    fixed.autoplay = false;
    play(fixed);
    drain();
    for (const int frame : {1, 29, 30, 31, 500, 998}) {
        const ReceivedFrame shown = shownBy([&](auto& device) { device.seek(frame / 30.0); });
        EXPECT_EQ(shown.value, static_cast<float>(frame));
        EXPECT_DOUBLE_EQ(shown.sourceTime_s, frame / 30.0);
    }
    EXPECT_EQ(shownBy([](auto& device) { device.step(-1); }).value, 997.0F);
}

TEST_F(ReplayControlTest, findsEveryFrameOfALongRecordingThroughItsIndex) {
    constexpr int kFrames = 50'000; // more than the index has places
    openPaused(kFrames);
    drain();
    for (const int frame : {49'999, 3, 12'345, 4096, 40'000, 1}) {
        EXPECT_EQ(shownBy([&](auto& device) { device.seek(0.1 * frame - 0.05); }).value,
                  static_cast<float>(frame));
        EXPECT_EQ(m_device->position().frame, static_cast<std::uint64_t>(frame));
    }
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->position().indexed; }));
    EXPECT_EQ(m_device->position().frames, static_cast<std::uint64_t>(kFrames));
    EXPECT_NEAR(m_device->position().duration_s, 0.1 * (kFrames - 1), 1e-6);
    for (const int frame : {30'000, 29'999, 2, 49'998})
        EXPECT_EQ(shownBy([&](auto& device) { device.seek(0.1 * frame - 0.05); }).value,
                  static_cast<float>(frame));
}

TEST_F(ReplayControlTest, finishesAndStartsOverWithPlay) {
    writeFrames(3);
    play(config());
    m_clock->advance(300 * kMs_ns);
    EXPECT_EQ(drain().size(), 3U);
    EXPECT_EQ(m_device->status().state, DeviceState::finished);
    EXPECT_TRUE(m_device->position().paused);
    m_device->play();
    const ReceivedFrame first = take(1).front();
    EXPECT_EQ(first.value, 0.0F);
    EXPECT_TRUE(first.discontinuity);
    EXPECT_EQ(first.number, 3U);
    EXPECT_EQ(m_device->status().state, DeviceState::live);
}

TEST_F(ReplayControlTest, canBeSearchedAfterTheEnd) {
    writeFrames(5);
    play(config());
    m_clock->advance(450 * kMs_ns);
    EXPECT_EQ(drain().size(), 5U);
    EXPECT_EQ(m_device->status().state, DeviceState::finished);
    EXPECT_EQ(shownBy([](auto& device) { device.step(-1); }).value, 3.0F);
    ASSERT_TRUE(comesTo(DeviceState::paused));
    m_device->play();
    ASSERT_TRUE(comesTo(DeviceState::live));
    m_clock->settle();
    m_clock->advance(101 * kMs_ns);
    EXPECT_EQ(drain().size(), 1U);
    EXPECT_EQ(m_device->status().state, DeviceState::finished);
}

TEST_F(ReplayControlTest, obeysTheLatestOfManySeeks) {
    openPaused(500);
    drain();
    for (int i = 0; i < 200; ++i)
        m_device->seek(0.1 * i);
    m_device->seek(44.4);
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->position().frame == 444U; }));
    m_clock->settle();
    EXPECT_EQ(drain().back().value, 444.0F);
    m_device->seek(std::nan(""));
    EXPECT_EQ(shownBy([](auto& device) { device.step(1); }).value, 445.0F);
}

TEST_F(ReplayControlTest, reportsItsControlsAtOnce) {
    openPaused(3);
    PlaybackPosition position = m_device->position();
    EXPECT_TRUE(position.paused);
    EXPECT_FALSE(position.loop);
    EXPECT_EQ(position.speed, 1.0);
    m_device->setLoop(true);
    m_device->setSpeed(2.0);
    m_device->play();
    position = m_device->position();
    EXPECT_FALSE(position.paused);
    EXPECT_TRUE(position.loop);
    EXPECT_EQ(position.speed, 2.0);
}

TEST_F(ReplayControlTest, takesCommandsFromAnotherThreadWhileItPlays) {
    writeFrames(5000);
    replay::CsvConfig unpaced = config();
    unpaced.clock = std::make_shared<core::PacingClock>();
    unpaced.speed = kUnpaced;
    unpaced.loop = true;
    unpaced.queueBlocks = 8;
    open(unpaced);
    m_device->start(m_wakeup);
    std::size_t frames = 0;
    for (int i = 0; i < 300; ++i) {
        switch (i % 6) {
        case 0:
            m_device->seek(i);
            break;
        case 1:
            m_device->step(i % 2 == 0 ? 3 : -3);
            break;
        case 2:
            m_device->setSpeed(i % 4 == 0 ? 100.0 : kUnpaced);
            break;
        case 3:
            m_device->pause();
            break;
        default:
            m_device->play();
        }
        frames += drain().size();
        (void)m_device->position();
        (void)m_device->status();
    }
    m_device->setSpeed(kUnpaced);
    m_device->play();
    ASSERT_TRUE(eventually(m_wakeup, [&] {
        frames += drain().size();
        return frames > 6000;
    }));
    m_device->stop();
    EXPECT_EQ(m_device->status().state, DeviceState::closed);
}
