// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/stream_columns.h"
#include "devices/replay/recorded_device.h"
#include "tests/backend/recording/recorded_files.h"
#include "tests/devices/manual_clock.h"

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
