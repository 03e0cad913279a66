// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/stream_columns.h"
#include "devices/replay/recorded_device.h"
#include "tests/backend/recording/recorded_files.h"
#include "tests/devices/manual_clock.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

constexpr std::int64_t kStart_ns = 5'000'000'000;
constexpr std::int64_t kPeriod_ns = 10'000'000;
constexpr double kUnpacedSpeed = std::numeric_limits<double>::infinity();

/// A recording of the joints of an arm at 100 Hz, whose first angle is the number of the sample.
class RecordedJointsTest : public testing::Test {
protected:
    RecordedJointsTest() { makeApplication(); }

    void write(int samples) {
        auto recorder = Recorder::start(path(), headAt(kStart_ns), {.simulatedTime = true}).value();
        const auto joints = recorder->addStream(jointStream(100.0, 4));
        for (int i = 0; i < samples; ++i) {
            core::JointSample sample;
            sample.angle_rad = {static_cast<double>(i), 0.0, 0.0, 0.0};
            sample.torque_Nm = {0.0, 0.0, 0.0, 0.5};
            const auto values = jointValues(sample, 4);
            joints->append(kStart_ns + i * kPeriod_ns, 0.0, std::span<const double>(values));
        }
        ASSERT_TRUE(recorder->stop());
    }

    /// The same with a force at the wrist, five times for each sample, whose x is the time since the start
    /// in ms.
    void writeWithWrench(int samples) {
        auto recorder = Recorder::start(path(), headAt(kStart_ns), {.simulatedTime = true}).value();
        recording::StreamInfo info = jointStream(100.0, 4);
        info.name = "arm-joints";
        const auto joints = recorder->addStream(info);
        const auto forces = recorder->addStream(pipeline::wrenchStream("arm-wrench", {}, nullptr));
        for (int i = 0; i < samples; ++i) {
            core::JointSample sample;
            sample.angle_rad = {static_cast<double>(i), 0.0, 0.0, 0.0};
            sample.torque_Nm = core::JointVector::zeros(4);
            const auto values = jointValues(sample, 4);
            joints->append(kStart_ns + i * kPeriod_ns, 0.0, std::span<const double>(values));
            for (int k = 0; k < 5; ++k) {
                const std::int64_t since_ns = i * kPeriod_ns + k * kPeriod_ns / 5;
                const std::array<double, 6> force{1e-6 * static_cast<double>(since_ns), 0, 0, 0, 0, 2.5};
                forces->append(kStart_ns + since_ns, 0.0, std::span<const double>(force));
            }
        }
        ASSERT_TRUE(recorder->stop());
    }

    [[nodiscard]] std::string path() const { return m_folder.path("run.teleta"); }

    TemporaryFolder m_folder;
    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::Wakeup m_wakeup;
};

} // namespace

TEST_F(RecordedJointsTest, anArmWithoutASkinIsPlayedAlone) {
    write(31);
    replay::RecordedConfig config;
    config.path = path();
    config.jointsAlone = true;
    config.autoplay = false;
    config.clock = m_clock;
    auto player = replay::RecordedPlayer::open(config);
    ASSERT_TRUE(player) << core::describe(player.error());
    replay::RecordedJoints arm(*player);
    arm.start(m_wakeup);
    m_clock->settle();
    const auto received = [&arm] {
        std::vector<double> angles;
        core::JointSample sample;
        while (arm.joints().pop(sample)) {
            angles.push_back(sample.angle_rad[0]);
            EXPECT_EQ(sample.torque_Nm[3], 0.5);
        }
        return angles;
    };
    const auto comesTo = [&](core::DeviceState state) {
        return eventually(m_wakeup, [&] { return arm.status().state == state; });
    };
    EXPECT_TRUE(comesTo(core::DeviceState::paused));
    EXPECT_EQ(received(), std::vector<double>{0.0});
    arm.play();
    ASSERT_TRUE(comesTo(core::DeviceState::live));
    m_clock->advance(3 * kPeriod_ns);
    EXPECT_EQ(received(), (std::vector<double>{1.0, 2.0, 3.0}));
    arm.pause();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    arm.seek(0.1);
    EXPECT_TRUE(eventually(m_wakeup, [&] { return received() == std::vector<double>{10.0}; }));
    EXPECT_TRUE(comesTo(core::DeviceState::paused));
    EXPECT_NEAR(arm.position().time_s, 0.1, 1e-9);
    EXPECT_NEAR(arm.position().duration_s, 0.3, 1e-9);
    arm.play();
    ASSERT_TRUE(comesTo(core::DeviceState::live));
    m_clock->advance(20 * kPeriod_ns);
    EXPECT_EQ(received().size(), 20U);
    EXPECT_TRUE(comesTo(core::DeviceState::finished));
    arm.stop();
}

TEST_F(RecordedJointsTest, anUnpacedArmWithoutASkinLosesNothing) {
    write(990);
    replay::RecordedConfig config;
    config.path = path();
    config.jointsAlone = true;
    config.speed = kUnpacedSpeed;
    config.queueJoints = 128;
    auto player = replay::RecordedPlayer::open(config);
    ASSERT_TRUE(player) << core::describe(player.error());
    replay::RecordedJoints arm(*player);
    arm.start(m_wakeup);
    double next = 0.0;
    EXPECT_TRUE(eventually(m_wakeup, [&] {
        core::JointSample sample;
        while (arm.joints().pop(sample)) {
            EXPECT_EQ(sample.angle_rad[0], next);
            next += 1.0;
        }
        return next >= 990.0;
    }));
    EXPECT_EQ(arm.status().framesLost, 0U);
    arm.stop();
}

TEST_F(RecordedJointsTest, theForceAtTheWristIsPlayedWithTheJoints) {
    writeWithWrench(31);
    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording);
    replay::RecordedConfig config;
    for (std::size_t i = 0; i < recording->streams().size(); ++i) {
        if (recording->streams()[i].kind == StreamKind::wrench)
            config.wrenchStream = i;
        else
            config.stream = i;
    }
    ASSERT_TRUE(config.wrenchStream);
    config.path = path();
    config.jointsAlone = true;
    config.autoplay = false;
    config.clock = m_clock;
    auto player = replay::RecordedPlayer::open(config);
    ASSERT_TRUE(player) << core::describe(player.error());
    replay::RecordedJoints arm(*player);
    ASSERT_NE(arm.wrenches(), nullptr);
    arm.start(m_wakeup);
    m_clock->settle();
    const auto comesTo = [&](core::DeviceState state) {
        return eventually(m_wakeup, [&] { return arm.status().state == state; });
    };
    const auto forces = [&arm] {
        std::vector<double> told;
        core::WrenchSample sample;
        while (arm.wrenches()->pop(sample)) {
            told.push_back(sample.force_N[0]);
            EXPECT_EQ(sample.torque_Nm[2], 2.5);
        }
        return told;
    };
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    EXPECT_EQ(forces(), std::vector<double>{0.0});
    arm.play();
    ASSERT_TRUE(comesTo(core::DeviceState::live));
    m_clock->advance(2 * kPeriod_ns);
    EXPECT_EQ(forces(), (std::vector<double>{2, 4, 6, 8, 10, 12, 14, 16, 18, 20}));
    arm.pause();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    arm.seek(0.105);
    // What was measured last before the sample that is shown is known too.
    EXPECT_TRUE(eventually(m_wakeup, [&] {
        const std::vector<double> told = forces();
        return told == std::vector<double>{108.0, 110.0};
    }));
    arm.play();
    ASSERT_TRUE(comesTo(core::DeviceState::live));
    m_clock->advance(20 * kPeriod_ns);
    ASSERT_TRUE(comesTo(core::DeviceState::finished));
    const std::vector<double> rest = forces();
    ASSERT_FALSE(rest.empty());
    EXPECT_EQ(rest.front(), 112.0);
    EXPECT_EQ(rest.back(), 300.0) << "up to the last sample of the joints";
    arm.stop();

    replay::RecordedConfig without = config;
    without.wrenchStream.reset();
    const auto other = replay::RecordedPlayer::open(without);
    ASSERT_TRUE(other);
    EXPECT_EQ(replay::RecordedJoints(*other).wrenches(), nullptr);
}
