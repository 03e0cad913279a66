// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/replay/replay_fixture.h"

using namespace teleta;
using core::DeviceState;
using test::eventually;
using test::kMs_ns;
using test::kUnpaced;
using test::ReceivedFrame;

class ReplayDeviceTest : public test::ReplayTest {};

TEST_F(ReplayDeviceTest, describesTheRecording) {
    writeFrames(50);
    open(config());
    const core::SourceDescription& description = m_device->description();
    EXPECT_EQ(testing::TempDir() + description.name, m_path);
    EXPECT_EQ(description.layout, (core::ArrayLayout{1, 2, 0.01}));
    EXPECT_NEAR(description.nominalRate_Hz, 10.0, 1e-9);
    EXPECT_TRUE(description.recorded);
    EXPECT_FALSE(description.simulated);
    EXPECT_EQ(m_device->playback(), m_device.get());
    EXPECT_EQ(m_device->status().state, DeviceState::closed);
}

TEST_F(ReplayDeviceTest, refusesWhatIsNoRecordingOfThisLayout) {
    EXPECT_EQ(replay::RecordedPlayer::open(config()).error().kind, core::ErrorKind::notFound);
    write("time_s,t0,t1\n");
    EXPECT_FALSE(replay::RecordedPlayer::open(config())) << "no frames";
    write("time_s,t0\n0,1\n");
    EXPECT_FALSE(replay::RecordedPlayer::open(config())) << "another layout";
    write("time_s,t0,t1\n0,1,x\n");
    const auto broken = replay::RecordedPlayer::open(config());
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().where.line, 2);
    EXPECT_EQ(broken.error().where.column, 5);
}

TEST_F(ReplayDeviceTest, playsAtTheRecordedSpeed) {
    writeFrames(20);
    play(config());
    const std::int64_t begin_ns = m_clock->now_ns();
    m_clock->advance(99 * kMs_ns);
    EXPECT_EQ(drain().size(), 1U) << "the first frame is due at once, the second after 100 ms";
    EXPECT_EQ(m_device->status().state, DeviceState::live);
    for (int i = 0; i < 100; ++i)
        m_clock->advance(10 * kMs_ns);
    const std::vector<ReceivedFrame> frames = drain();
    ASSERT_EQ(frames.size(), 10U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].value, static_cast<float>(i + 1));
        EXPECT_EQ(frames[i].number, i + 1);
        EXPECT_DOUBLE_EQ(frames[i].sourceTime_s, 100.1 + 0.1 * static_cast<double>(i));
        EXPECT_FALSE(frames[i].discontinuity);
        const std::int64_t due_ns = begin_ns + static_cast<std::int64_t>(i + 1) * 100 * kMs_ns;
        EXPECT_GE(frames[i].time_ns, due_ns - 1000);
        EXPECT_LE(frames[i].time_ns, due_ns + 10 * kMs_ns);
    }
}

TEST_F(ReplayDeviceTest, playsFasterAndSlower) {
    writeFrames(2000);
    replay::CsvConfig fast = config();
    fast.speed = 50.0; // 500 Hz
    fast.queueBlocks = 1000;
    play(fast);
    for (int i = 0; i < 999; ++i)
        m_clock->advance(1 * kMs_ns);
    EXPECT_EQ(drain().size(), 500U) << "due at 0, 2, ... 998 ms";

    m_device->setSpeed(0.5); // 5 Hz
    m_clock->settle();
    for (int i = 0; i < 1000; ++i)
        m_clock->advance(1 * kMs_ns);
    // The worker takes the command a moment after it was given.
    EXPECT_NEAR(static_cast<double>(drain().size()), 5.0, 2.0);
    EXPECT_EQ(m_device->status().framesLost, 0U);
}

TEST_F(ReplayDeviceTest, clampsTheSpeed) {
    writeFrames(3);
    open(config());
    m_device->setSpeed(1000.0);
    EXPECT_EQ(m_device->position().speed, 100.0);
    m_device->setSpeed(0.0);
    EXPECT_EQ(m_device->position().speed, 0.01);
    m_device->setSpeed(-kUnpaced);
    EXPECT_EQ(m_device->position().speed, 0.01);
    m_device->setSpeed(std::nan(""));
    EXPECT_EQ(m_device->position().speed, 0.01);
    m_device->setSpeed(kUnpaced);
    EXPECT_EQ(m_device->position().speed, kUnpaced);
}

TEST_F(ReplayDeviceTest, takesAFixedRateInsteadOfTheRecordedTimes) {
    writeFrames(400);
    replay::CsvConfig fixed = config();
    fixed.rate_Hz = 200.0;
    play(fixed);
    EXPECT_EQ(m_device->description().nominalRate_Hz, 200.0);
    for (int i = 0; i < 199; ++i)
        m_clock->advance(5 * kMs_ns);
    const std::vector<ReceivedFrame> frames = drain();
    ASSERT_EQ(frames.size(), 200U);
    EXPECT_DOUBLE_EQ(frames[0].sourceTime_s, 0.0);
    EXPECT_DOUBLE_EQ(frames[199].sourceTime_s, 199.0 / 200.0);
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->position().indexed; }));
    EXPECT_DOUBLE_EQ(m_device->position().duration_s, 399.0 / 200.0);
    EXPECT_DOUBLE_EQ(m_device->position().time_s, 199.0 / 200.0);
}

TEST_F(ReplayDeviceTest, losesNothingAsFastAsTheConsumerTakesIt) {
    constexpr int kFrames = 30'000;
    writeFrames(kFrames);
    replay::CsvConfig unpaced = config();
    unpaced.clock = std::make_shared<core::PacingClock>();
    unpaced.speed = kUnpaced;
    unpaced.queueBlocks = 2;
    open(unpaced);
    m_device->start(m_wakeup);
    const std::vector<ReceivedFrame> frames = take(kFrames);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        ASSERT_EQ(frames[i].value, static_cast<float>(i));
        ASSERT_EQ(frames[i].number, i);
        ASSERT_FALSE(frames[i].discontinuity);
    }
    ASSERT_TRUE(comesTo(DeviceState::finished));
    EXPECT_EQ(m_device->status().framesRead, static_cast<std::uint64_t>(kFrames));
    EXPECT_EQ(m_device->status().framesLost, 0U);
    EXPECT_TRUE(m_device->position().paused);
}

TEST_F(ReplayDeviceTest, countsWhatAFullQueueLosesAtAFiniteSpeed) {
    writeFrames(20);
    replay::CsvConfig small = config();
    small.queueBlocks = 3;
    play(small);
    for (int i = 0; i < 9; ++i)
        m_clock->advance(100 * kMs_ns + 1000);
    EXPECT_EQ(m_device->status().framesRead, 10U);
    EXPECT_EQ(m_device->status().framesLost, 7U);
    EXPECT_EQ(drain().size(), 3U);
    m_clock->advance(100 * kMs_ns);
    const std::vector<ReceivedFrame> frames = drain();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].number, 10U) << "the gap in the numbers is the loss";
}

TEST_F(ReplayDeviceTest, keepsTheFramesBeforeARowThatCannotBeRead) {
    write("time_s,t0,t1\n" + rows(40) + "104.0,40,oops\n" + rows(10, 41));
    replay::CsvConfig unpaced = config();
    unpaced.clock = std::make_shared<core::PacingClock>();
    unpaced.speed = kUnpaced;
    unpaced.loop = true;
    open(unpaced);
    m_device->start(m_wakeup);
    EXPECT_EQ(take(40).back().value, 39.0F);
    ASSERT_TRUE(comesTo(DeviceState::lost));
    EXPECT_NE(m_device->status().message.find(m_path + ":42:10: "), std::string::npos)
        << m_device->status().message;
    EXPECT_TRUE(m_device->position().paused);
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->position().indexed; }));
    EXPECT_EQ(m_device->position().frames, 40U);

    // What was read stays within reach, and playing starts over.
    EXPECT_EQ(shownBy([](auto& device) { device.step(-1); }).value, 38.0F);
    EXPECT_TRUE(comesTo(DeviceState::paused));
    EXPECT_TRUE(m_device->status().message.empty());
    m_device->play();
    EXPECT_EQ(take(1).front().value, 39.0F);
    ASSERT_TRUE(comesTo(DeviceState::lost));
    m_device->play();
    const std::vector<ReceivedFrame> again = take(40);
    EXPECT_EQ(again.front().value, 0.0F);
    EXPECT_TRUE(again.front().discontinuity);
}

TEST_F(ReplayDeviceTest, repeatsInALoopAndMarksTheSeam) {
    writeFrames(5);
    replay::CsvConfig looped = config();
    looped.loop = true;
    play(looped);
    for (int i = 0; i < 122; ++i)
        m_clock->advance(10 * kMs_ns); // 1.22 s: 13 frames of 100 ms
    const std::vector<ReceivedFrame> frames = drain();
    ASSERT_EQ(frames.size(), 13U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].value, static_cast<float>(i % 5));
        EXPECT_EQ(frames[i].number, i) << "the stream goes on";
        EXPECT_EQ(frames[i].discontinuity, i == 5 || i == 10);
    }
    EXPECT_EQ(m_device->position().frame, 2U);

    m_device->setLoop(false);
    for (int i = 0; i < 50; ++i)
        m_clock->advance(10 * kMs_ns);
    EXPECT_EQ(drain().size(), 2U);
    EXPECT_EQ(m_device->status().state, DeviceState::finished);
}

TEST_F(ReplayDeviceTest, loopsASingleFrameWithoutRunningAway) {
    writeFrames(1);
    replay::CsvConfig looped = config();
    looped.loop = true;
    play(looped);
    for (int i = 0; i < 10; ++i)
        m_clock->advance(100 * kMs_ns);
    EXPECT_EQ(drain().size(), 11U);
    EXPECT_EQ(m_device->position().duration_s, 0.0);
}

TEST_F(ReplayDeviceTest, waitsThroughAGapHoweverLong) {
    write("time_s,t0,t1\n0,0,7\n1e300,1,7\n");
    play(config());
    EXPECT_EQ(drain().size(), 1U);
    m_clock->advance(3600'000 * kMs_ns);
    EXPECT_TRUE(drain().empty());
    m_device->seek(1.0);
    EXPECT_EQ(take(1).front().value, 1.0F);
}

TEST_F(ReplayDeviceTest, deliversFramesOfOneTimeTogether) {
    write("time_s,t0,t1\n0,0,7\n0,1,7\n0,2,7\n1,3,7\n");
    play(config());
    EXPECT_EQ(drain().size(), 3U);
    EXPECT_GT(m_device->description().nominalRate_Hz, 0.0);
}

TEST_F(ReplayDeviceTest, stopsAtOnceAndStartsAnew) {
    writeFrames(20);
    play(config());
    m_clock->advance(250 * kMs_ns);
    EXPECT_EQ(drain().size(), 3U);
    m_device->stop();
    m_device->stop();
    EXPECT_EQ(m_device->status().state, DeviceState::closed);

    m_device->start(m_wakeup);
    m_clock->settle();
    const std::vector<ReceivedFrame> frames = drain();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].value, 0.0F);
    EXPECT_EQ(frames[0].number, 0U);
    EXPECT_TRUE(frames[0].discontinuity);
    EXPECT_EQ(m_device->status().framesRead, 1U);
    m_device->pause();
    ASSERT_TRUE(comesTo(DeviceState::paused));
    m_device->stop();
    EXPECT_EQ(m_device->status().state, DeviceState::closed);
}
