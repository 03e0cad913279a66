// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/stream_columns.h"
#include "devices/replay/recorded_device.h"
#include "tests/backend/recording/recorded_files.h"
#include "tests/devices/manual_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

constexpr std::int64_t kStart_ns = 5'000'000'000;
constexpr std::int64_t kTenth_ns = 100'000'000;
constexpr double kUnpacedSpeed = std::numeric_limits<double>::infinity();

/// A recording of an array at 10 Hz, whose first taxel is the number of the frame, and of joints at 100 Hz,
/// whose first angle is the number of the sample; both begin 1 s after the recording.
class RecordedDeviceTest : public testing::Test {
protected:
    RecordedDeviceTest() { makeApplication(); }
    ~RecordedDeviceTest() override {
        m_array.reset();
        m_arm.reset();
    }

    /// late_ns: of the joints, after the instants of the frames.
    void write(int frames, std::int64_t late_ns = 0) {
        auto recorder = Recorder::start(path(), headAt(kStart_ns), {.simulatedTime = true}).value();
        const auto array = recorder->addStream(arrayInfo());
        const auto joints = recorder->addStream(jointStream(100.0, 4));
        const std::int64_t first_ns = kStart_ns + 1'000'000'000;
        for (int i = 0; i < frames; ++i) {
            appendFrame(*array, first_ns + i * kTenth_ns, static_cast<float>(i));
            for (int k = 0; k < 10 && i + 1 < frames; ++k) {
                core::JointSample sample;
                sample.angle_rad = {10.0 * i + k, 0.0, 0.0, 0.0};
                sample.torque_Nm = {0.0, 0.0, 0.0, 0.5};
                const auto values = jointValues(sample, 4);
                joints->append(first_ns + late_ns + i * kTenth_ns + k * kTenth_ns / 10, 0.0,
                               std::span<const double>(values));
            }
        }
        ASSERT_TRUE(recorder->stop());
    }

    /// Frames 0, 1, 2, ... at these times, each a block of its own after a jump.
    void writeAt(const std::vector<double>& times_s) {
        auto recorder = Recorder::start(path(), headAt(kStart_ns), {.simulatedTime = true}).value();
        const auto array = recorder->addStream(arrayInfo());
        for (std::size_t i = 0; i < times_s.size(); ++i) {
            const std::array<float, kTaxels> values{static_cast<float>(i)};
            array->append(kStart_ns + std::llround(times_s[i] * 1e9), times_s[i],
                          std::span<const float>(values), true);
        }
        ASSERT_TRUE(recorder->stop());
    }

    void open(bool arm = false, double speed = 1.0) {
        replay::RecordedConfig config;
        config.speed = speed;
        config.path = path();
        config.array.layout = core::ArrayLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};
        config.clock = m_clock;
        if (arm)
            config.jointStream = 1;
        auto player = replay::RecordedPlayer::open(std::move(config));
        ASSERT_TRUE(player) << core::describe(player.error());
        m_array = std::make_unique<replay::RecordedArray>(*player);
        m_arm = std::make_unique<replay::RecordedArm>(*player);
        m_array->start(m_wakeup);
        m_arm->start(m_wakeup);
        m_clock->settle();
    }

    std::vector<float> received() {
        std::vector<float> values;
        core::SampleBlock block;
        while (m_array->blocks().pop(block)) {
            m_jumps += block.discontinuity ? 1 : 0;
            for (std::size_t i = 0; i < block.frames(); ++i) {
                values.push_back(block.frame(i)[0]);
                m_time_ns.push_back(block.time_ns[i]);
                m_sourceTime_s.push_back(block.sourceTime_s[i]);
            }
        }
        return values;
    }

    /// Waits for so many frames.
    std::vector<float> take(std::size_t count) {
        std::vector<float> values;
        EXPECT_TRUE(eventually(m_wakeup, [&] {
            const std::vector<float> more = received();
            values.insert(values.end(), more.begin(), more.end());
            return values.size() >= count;
        }));
        return values;
    }

    bool comesTo(core::DeviceState state) {
        return eventually(m_wakeup, [&] { return m_array->status().state == state; });
    }

    [[nodiscard]] std::string path() const { return m_folder.path("run.teleta"); }

    TemporaryFolder m_folder;
    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::Wakeup m_wakeup;
    std::unique_ptr<replay::RecordedArray> m_array;
    std::unique_ptr<replay::RecordedArm> m_arm;
    int m_jumps = 0;
    std::vector<std::int64_t> m_time_ns;
    std::vector<double> m_sourceTime_s;
};

using Values = std::vector<float>;

} // namespace

TEST_F(RecordedDeviceTest, ASingleFrameThatIsToBeRepeatedEnds) {
    writeAt({1.0});
    open();
    EXPECT_EQ(take(1), Values{0});
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
    m_array->setLoop(true);
    m_array->play();
    EXPECT_EQ(take(1), Values{0});
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
}

TEST_F(RecordedDeviceTest, WhereItGoesOnIsKnownBeforeTheSeekIsCarriedOut) {
    write(11);
    open();
    m_array->pause();
    m_array->seek(0.3);
    EXPECT_DOUBLE_EQ(m_array->position().target_s, 0.3);
    EXPECT_TRUE(eventually(m_wakeup, [&] { return std::abs(m_array->position().time_s - 0.3) < 1e-9; }));
    EXPECT_DOUBLE_EQ(m_array->position().target_s, 0.3);
    m_array->seek(70.0);
    EXPECT_EQ(m_array->position().target_s, m_array->position().duration_s);
    m_array->step(-2);
    EXPECT_TRUE(eventually(m_wakeup, [&] { return m_array->position().target_s < 0.9; }));
    EXPECT_EQ(m_array->position().target_s, m_array->position().time_s);
}

TEST_F(RecordedDeviceTest, framesComeWhenTheyAreDueAndTheEndIsTold) {
    write(4);
    open();
    EXPECT_EQ(received(), Values{0.0F});
    m_clock->advance(kTenth_ns - 1);
    EXPECT_EQ(received(), Values{});
    m_clock->advance(1);
    EXPECT_EQ(received(), Values{1.0F});
    EXPECT_EQ(m_array->status().state, core::DeviceState::live);
    m_clock->advance(2 * kTenth_ns);
    EXPECT_EQ(received(), (Values{2.0F, 3.0F}));
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
    EXPECT_EQ(m_array->status().framesRead, 4U);
    EXPECT_EQ(m_jumps, 1) << "the beginning";
    EXPECT_EQ(m_time_ns[3] - m_time_ns[2], kTenth_ns) << "as they were due";
    EXPECT_DOUBLE_EQ(m_sourceTime_s[0], 1.0) << "since the recording's start";
    EXPECT_DOUBLE_EQ(m_sourceTime_s[3], 1.3);
}

TEST_F(RecordedDeviceTest, anArmIsPlayedInStepWithItsSkin) {
    write(4);
    open(true);
    m_clock->advance(kTenth_ns);
    core::JointSample sample;
    std::vector<double> angles;
    std::int64_t last_ns = 0;
    while (m_arm->joints().pop(sample)) {
        angles.push_back(sample.angle_rad[0]);
        EXPECT_EQ(sample.discontinuity, angles.size() == 1);
        EXPECT_EQ(sample.torque_Nm[3], 0.5);
        last_ns = sample.time_ns;
    }
    ASSERT_EQ(angles.size(), 11U);
    EXPECT_EQ(angles.back(), 10.0);
    EXPECT_EQ(received(), (Values{0.0F, 1.0F}));
    EXPECT_EQ(last_ns, m_time_ns.back()) << "the sample and the frame of the same instant";
    EXPECT_EQ(m_arm->status().framesRead, 11U);
}

TEST_F(RecordedDeviceTest, aPausedArmThatIsSetBackStandsWhereItWasThen) {
    write(10, kTenth_ns / 20);
    open(true);
    m_clock->advance(kTenth_ns);
    m_array->pause();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    (void)received();
    core::JointSample sample;
    while (m_arm->joints().pop(sample)) {
    }
    m_array->seek(0.65);
    EXPECT_EQ(take(1), Values{7.0F});
    ASSERT_TRUE(m_arm->joints().pop(sample));
    EXPECT_EQ(sample.angle_rad[0], 69.0) << "half a sample before the frame";
    EXPECT_FALSE(m_arm->joints().pop(sample));
}

TEST_F(RecordedDeviceTest, speedPauseSeekStepAndLoopAreControlled) {
    write(10);
    open(false, 2.0);
    m_clock->advance(kTenth_ns); // twice as fast: two frames
    EXPECT_EQ(received(), (Values{0.0F, 1.0F, 2.0F}));
    m_array->pause();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    m_clock->advance(10 * kTenth_ns);
    EXPECT_EQ(received(), Values{});
    m_array->seek(0.65);
    EXPECT_EQ(take(1), Values{7.0F});
    EXPECT_NEAR(m_array->position().time_s, 0.7, 1e-9);
    EXPECT_NEAR(m_array->position().duration_s, 0.9, 1e-9);
    EXPECT_EQ(m_array->position().frame, 7U);
    EXPECT_EQ(m_array->position().frames, 10U);
    m_array->step(-2);
    EXPECT_EQ(take(1), Values{5.0F});
    m_array->step(1);
    EXPECT_EQ(take(1), Values{6.0F});
    m_array->seek(100.0);
    EXPECT_EQ(take(1), Values{9.0F});
    m_array->setLoop(true);
    m_array->setSpeed(1.0);
    m_array->play();
    ASSERT_TRUE(comesTo(core::DeviceState::live));
    m_clock->advance(kTenth_ns); // the seam is a period long
    EXPECT_EQ(take(1), Values{0.0F});
    m_clock->advance(kTenth_ns);
    EXPECT_EQ(take(1), Values{1.0F});
    EXPECT_EQ(received(), Values{});
}

TEST_F(RecordedDeviceTest, anUnpacedPlaybackWaitsForItsConsumerAndLosesNothing) {
    write(500);
    replay::RecordedConfig config;
    config.speed = kUnpacedSpeed;
    config.queueBlocks = 2;
    config.path = path();
    config.array.layout = core::ArrayLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};
    config.clock = std::make_shared<core::PacingClock>();
    auto player = replay::RecordedPlayer::open(config);
    ASSERT_TRUE(player);
    m_array = std::make_unique<replay::RecordedArray>(*player);
    m_array->start(m_wakeup);
    Values all;
    while (all.size() < 500 && m_array->status().state != core::DeviceState::lost) {
        const Values some = received();
        all.insert(all.end(), some.begin(), some.end());
        std::this_thread::yield();
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        ASSERT_EQ(all[i], static_cast<float>(i));
    EXPECT_EQ(m_array->status().framesLost, 0U);
}

TEST_F(RecordedDeviceTest, aStepIsAFrameHoweverUnevenlyTheyCame) {
    writeAt({1.0, 1.001, 1.002, 5.0, 5.5, 5.501});
    open();
    m_array->pause();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    EXPECT_EQ(received(), Values{0.0F});
    for (int i = 1; i < 6; ++i) {
        m_array->step(1);
        EXPECT_EQ(take(1), Values{static_cast<float>(i)});
    }
    m_array->step(-2);
    EXPECT_EQ(take(1), Values{3.0F});
    m_array->step(-1);
    EXPECT_EQ(take(1), Values{2.0F});
    m_array->step(2);
    EXPECT_EQ(take(1), Values{4.0F});
    m_array->step(-100); // to the first one
    EXPECT_EQ(take(1), Values{0.0F});
    m_array->step(-1); // there is none
    m_array->step(100);
    EXPECT_EQ(take(1), Values{5.0F});
    m_array->step(1);
    m_clock->settle();
    EXPECT_EQ(received(), Values{});
}

TEST_F(RecordedDeviceTest, stepsGoThroughBlocksOfManyFrames) {
    write(1200);
    open();
    m_array->pause();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    EXPECT_EQ(received(), Values{0.0F});
    m_array->step(1150);
    EXPECT_EQ(take(1), Values{1150.0F});
    m_array->step(-1100);
    EXPECT_EQ(take(1), Values{50.0F});
    m_array->step(-1);
    EXPECT_EQ(take(1), Values{49.0F});
    m_array->step(1);
    EXPECT_EQ(take(1), Values{50.0F});
}

TEST_F(RecordedDeviceTest, jumpsInTheRecordingAreToldWhenItIsPlayedAsFastAsPossible) {
    writeAt({1.0, 1.1, 1.2, 1.3});
    open(false, kUnpacedSpeed);
    EXPECT_EQ(take(4), (Values{0.0F, 1.0F, 2.0F, 3.0F}));
    EXPECT_EQ(m_jumps, 4);
}

TEST_F(RecordedDeviceTest, framesBehindADamagedBlockAreAJump) {
    writeAt({1.0, 1.1, 1.2, 1.3});
    askFile(path(), QStringLiteral("UPDATE block SET discontinuity = 0"));
    askFile(path(), QStringLiteral("UPDATE block SET data = x'00' WHERE key = 2"));
    open(false, kUnpacedSpeed);
    EXPECT_EQ(take(3), (Values{0.0F, 2.0F, 3.0F}));
    EXPECT_EQ(m_jumps, 2) << "the beginning and the damage";
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
    m_clock->settle();
    EXPECT_EQ(m_array->damagedBlocks(), 1U);
}

TEST_F(RecordedDeviceTest, theLastWholeFrameIsShownWhereTheEndIsDamaged) {
    writeAt({1.0, 1.1, 1.2, 1.3});
    askFile(path(), QStringLiteral("UPDATE block SET data = x'00' WHERE key = 4"));
    open();
    m_array->pause();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    EXPECT_EQ(received(), Values{0.0F});
    m_array->seek(100.0);
    EXPECT_EQ(take(1), Values{2.0F});
    m_array->step(-1);
    EXPECT_EQ(take(1), Values{1.0F});
}

// As fast as possible, frames are stamped ahead of the clock.
TEST_F(RecordedDeviceTest, leavingTheHighestSpeedIsAJumpBack) {
    write(2000);
    replay::RecordedConfig config;
    config.speed = kUnpacedSpeed;
    config.queueBlocks = 2;
    config.path = path();
    config.array.layout = core::ArrayLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};
    config.clock = std::make_shared<core::PacingClock>();
    m_array = std::make_unique<replay::RecordedArray>(replay::RecordedPlayer::open(config).value());
    m_array->start(m_wakeup);
    take(64);
    ASSERT_EQ(m_jumps, 1);
    m_array->setSpeed(100.0);
    EXPECT_TRUE(eventually(m_wakeup, [&] {
        (void)received();
        return m_jumps == 2;
    }));
    EXPECT_FALSE(std::ranges::is_sorted(m_time_ns));
}

TEST_F(RecordedDeviceTest, aDamagedBlockIsPassedOver) {
    write(10);
    askFile(path(), QStringLiteral("UPDATE block SET data = x'00' WHERE stream = 2"));
    open(true);
    for (int i = 0; i < 9; ++i)
        m_clock->advance(kTenth_ns);
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
    EXPECT_EQ(received().size(), 10U);
    EXPECT_EQ(m_arm->status().framesRead, 0U);
}

TEST_F(RecordedDeviceTest, onlyTheBlockOfAPageThatCannotBeReadIsPassedOver) {
    recordLargeBlocks(path(), kStart_ns, 6);
    damageLargeBlock(path(), 0);
    damageLargeBlock(path(), 3);
    replay::RecordedConfig config;
    config.speed = kUnpacedSpeed;
    config.path = path();
    config.array.layout = core::ArrayLayout{.rows = 32, .columns = 32, .pitchX_m = 0.01};
    config.clock = m_clock;
    m_array = std::make_unique<replay::RecordedArray>(replay::RecordedPlayer::open(config).value());
    m_array->start(m_wakeup);
    Values whole;
    for (const int block : {1, 2, 4, 5}) {
        for (int i = 0; i < kLargeFrames; ++i)
            whole.push_back(static_cast<float>(block * kLargeFrames + i));
    }
    EXPECT_EQ(take(whole.size()), whole);
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
    m_clock->settle();
    EXPECT_EQ(m_array->position().damagedBlocks, 2U);
    m_array->seek(0.0);
    EXPECT_EQ(take(1), Values{10.0F});
    m_array->seek(0.033);
    EXPECT_EQ(take(1), Values{40.0F});
    m_array->step(-1);
    EXPECT_EQ(take(1), Values{29.0F});
}

TEST_F(RecordedDeviceTest, anArmIsPlayedWithoutItsSkinWhereNothingOfThatCanBeRead) {
    write(4);
    askFile(path(), QStringLiteral("UPDATE block SET data = x'00' WHERE stream = 1"));
    open(true);
    for (int i = 0; i < 3; ++i)
        m_clock->advance(kTenth_ns);
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
    m_clock->settle();
    EXPECT_EQ(received(), Values{});
    EXPECT_EQ(m_arm->status().framesRead, 30U);
    EXPECT_GE(m_array->position().damagedBlocks, 1U);
    m_array->step(1);
    m_array->step(-1);
    m_clock->settle();
    EXPECT_EQ(received(), Values{});
}

TEST_F(RecordedDeviceTest, aRecordingWithoutFramesIsRefused) {
    {
        auto recorder = Recorder::start(path(), headAt(kStart_ns), {.simulatedTime = true}).value();
        (void)recorder->addStream(arrayInfo());
        ASSERT_TRUE(recorder->stop());
    }
    replay::RecordedConfig config;
    config.path = path();
    const auto player = replay::RecordedPlayer::open(config);
    ASSERT_FALSE(player);
    EXPECT_EQ(player.error().kind, core::ErrorKind::refused);
}

TEST_F(RecordedDeviceTest, whatIsPlayedTogetherHasOneTime) {
    write(4); // from 1.0 s to 1.3 s of the recording
    replay::RecordedConfig config;
    config.path = path();
    config.array.layout = core::ArrayLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};
    config.clock = m_clock;
    config.span = replay::RecordedConfig::Span{kStart_ns, kStart_ns + 2'000'000'000};
    auto player = replay::RecordedPlayer::open(config);
    ASSERT_TRUE(player);
    m_array = std::make_unique<replay::RecordedArray>(*player);
    m_array->start(m_wakeup);
    m_clock->settle();
    EXPECT_EQ(received(), Values{}) << "another source began earlier";
    EXPECT_NEAR(m_array->position().duration_s, 2.0, 1e-9);
    m_clock->advance(10 * kTenth_ns);
    EXPECT_EQ(received(), Values{0.0F});
    EXPECT_NEAR(m_array->position().time_s, 1.0, 1e-9);
    m_clock->advance(3 * kTenth_ns);
    EXPECT_EQ(received(), (Values{1.0F, 2.0F, 3.0F}));
    EXPECT_EQ(m_array->status().state, core::DeviceState::live) << "another source goes on";
    m_clock->advance(7 * kTenth_ns);
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
    m_array->seek(1.9);
    EXPECT_EQ(take(1), Values{3.0F}) << "as it was left";
    m_array->seek(0.5);
    m_clock->settle();
    EXPECT_EQ(received(), Values{}) << "there was nothing yet";
    EXPECT_TRUE(eventually(m_wakeup, [&] { return m_array->position().time_s == 0.5; }));
}

TEST_F(RecordedDeviceTest, anotherSpeedGoesOnFromTheTimeThatWasReached) {
    write(4);
    open();
    EXPECT_EQ(received(), Values{0.0F});
    m_clock->advance(kTenth_ns / 2);
    m_array->setSpeed(2.0);
    EXPECT_TRUE(m_clock->comesToWaitFor(m_clock->now_ns() + kTenth_ns / 4))
        << "half a period is left, at twice the speed";
}

namespace {

constexpr std::int64_t kSpan_ns = 1'000'000'000;

/// Two arrays of one recording: one at 10 Hz that begins at 0 s and ends at 1 s, and one at 4 Hz between
/// them, whose frames are those at 0.02, 0.27, 0.52 and 0.77 s.
void writeTwoArrays(const std::string& path) {
    auto recorder = Recorder::start(path, headAt(kStart_ns), {.simulatedTime = true}).value();
    StreamInfo slow = arrayInfo();
    slow.name = "slow";
    const auto fast = recorder->addStream(arrayInfo());
    const auto other = recorder->addStream(slow);
    for (int i = 0; i <= 10; ++i)
        appendFrame(*fast, kStart_ns + i * kTenth_ns, static_cast<float>(i));
    for (int i = 0; i < 4; ++i)
        appendFrame(*other, kStart_ns + 20'000'000 + i * 250'000'000, static_cast<float>(i));
    ASSERT_TRUE(recorder->stop());
}

replay::RecordedConfig partOfTwo(const std::string& path, std::size_t stream,
                                 std::shared_ptr<core::PacingClock> clock) {
    replay::RecordedConfig config;
    config.path = path;
    config.stream = stream;
    config.array.layout = core::ArrayLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};
    config.clock = std::move(clock);
    config.span = replay::RecordedConfig::Span{kStart_ns, kStart_ns + kSpan_ns};
    return config;
}

} // namespace

TEST_F(RecordedDeviceTest, whatIsPlayedTogetherStaysTogetherPassByPass) {
    writeTwoArrays(path());
    for (const std::size_t stream : {0U, 1U}) {
        SCOPED_TRACE(stream);
        m_clock = std::make_shared<ManualClock>();
        replay::RecordedConfig config = partOfTwo(path(), stream, m_clock);
        config.loop = true;
        m_array = std::make_unique<replay::RecordedArray>(replay::RecordedPlayer::open(config).value());
        m_time_ns.clear();
        m_sourceTime_s.clear();
        m_array->start(m_wakeup);
        m_clock->settle();
        const std::int64_t begin_ns = m_clock->now_ns();
        // Each seam is noticed late, and not by all sources at the same time.
        const std::int64_t step_ns = stream == 0 ? 30'000'000 : 70'000'000;
        while (m_clock->now_ns() - begin_ns < 5 * kSpan_ns) {
            m_clock->advance(step_ns);
            (void)received();
        }
        ASSERT_GE(m_time_ns.size(), 16U);
        std::int64_t pass = 0;
        for (std::size_t i = 0; i < m_time_ns.size(); ++i) {
            pass += i > 0 && m_sourceTime_s[i] < m_sourceTime_s[i - 1] ? 1 : 0;
            ASSERT_EQ(m_time_ns[i] - begin_ns, pass * kSpan_ns + std::llround(m_sourceTime_s[i] * 1e9))
                << "frame " << i;
        }
        EXPECT_GE(pass, 4);
    }
}

TEST_F(RecordedDeviceTest, whatIsPlayedTogetherPausesAtTheTimeThatWasReached) {
    writeTwoArrays(path());
    m_array = std::make_unique<replay::RecordedArray>(
        replay::RecordedPlayer::open(partOfTwo(path(), 1, m_clock)).value());
    m_array->start(m_wakeup);
    m_clock->settle();
    m_clock->advance(150'000'000); // its frames are those at 0.02 s and 0.27 s
    m_array->pause();
    EXPECT_TRUE(eventually(m_wakeup, [&] { return std::abs(m_array->position().time_s - 0.15) < 1e-9; }))
        << m_array->position().time_s;
    m_clock->advance(kSpan_ns);
    m_array->play();
    EXPECT_TRUE(m_clock->comesToWaitFor(m_clock->now_ns() + 120'000'000));
}

TEST_F(RecordedDeviceTest, whatIsBegunTogetherIsTogetherAlthoughItsFramesAreNot) {
    writeTwoArrays(path());
    replay::RecordedConfig config = partOfTwo(path(), 1, m_clock);
    config.autoplay = false;
    m_array = std::make_unique<replay::RecordedArray>(replay::RecordedPlayer::open(config).value());
    m_array->start(m_wakeup);
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    EXPECT_EQ(take(1), Values{0.0F}) << "what is there is shown";
    EXPECT_TRUE(eventually(m_wakeup, [&] { return m_array->position().time_s == 0.0; }))
        << "at the time of all sources";
    m_array->play();
    EXPECT_TRUE(m_clock->comesToWaitFor(m_clock->now_ns() + 270'000'000));
    m_array->seek(0.5);
    EXPECT_TRUE(m_clock->comesToWaitFor(m_clock->now_ns() + 20'000'000)) << "its next frame is at 0.52 s";
    EXPECT_EQ(received(), Values{});
}

TEST_F(RecordedDeviceTest, marksAreToldByTheTimeOfThePlayback) {
    {
        auto recorder = Recorder::start(path(), headAt(kStart_ns), {.simulatedTime = true}).value();
        const auto array = recorder->addStream(arrayInfo());
        appendFrame(*array, kStart_ns + 1'000'000'000, 1.0F);
        recorder->add({.time_ns = kStart_ns + 1'250'000'000, .kind = kMark, .text = "slipped"});
        ASSERT_TRUE(recorder->stop());
    }
    open();
    const auto marks = m_array->marks();
    ASSERT_EQ(marks.size(), 1U);
    EXPECT_NEAR(marks[0].time_s, 0.25, 1e-9) << "since the first frame";
    EXPECT_NEAR(marks[0].sourceTime_s, 1.25, 1e-9) << "since the recording's start";
    EXPECT_EQ(marks[0].text, "slipped");
}
