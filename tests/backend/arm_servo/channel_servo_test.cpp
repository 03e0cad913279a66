// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/channel_servo.h"
#include "tests/backend/arm_servo/servo_bench.h"
#include "tests/backend/pipeline/scripted_arm_source.h"
#include "tests/backend/pipeline/scripted_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace teleta::arm_servo {
namespace {

using core::JointVector;
using test::kLookingDown_rad;

/// An arm with a pad whose commands are kept.
class PaddedArm : public teleta::test::ScriptedArmSource {
public:
    explicit PaddedArm(core::ArmDescription description)
        : m_description(std::move(description)) {}
    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    [[nodiscard]] core::ArmDrive drive() const override { return driven; }
    [[nodiscard]] std::string hindrance() const override { return inTheWay; }

    core::ArmDrive driven = core::ArmDrive::held;
    std::string inTheWay;

private:
    core::ArmDescription m_description;
};

class ChannelServoTest : public ::testing::Test {
protected:
    void open(const std::string& unit = "N", bool recorded = false) {
        core::ArmDescription description = test::armWithPad(*chain);
        description.recorded = recorded;
        const core::PadPlacement pad = *description.pad;
        description.pad.reset(); // the channel knows it from the arm's file
        arm = new PaddedArm(description);
        array = new teleta::test::ScriptedSource(core::ArrayLayout{}, 4096);
        pipeline::ChannelSettings settings;
        settings.loadUnit = unit;
        channel = *pipeline::ArmChannel::withPad(
            std::unique_ptr<core::ArmSource>(arm),
            std::make_shared<pipeline::TouchChannel>(std::unique_ptr<core::TactileSource>(array), settings),
            chain, pad);
    }

    void tick(bool held, bool stopped = false) {
        now_ns += 33'000'000;
        core::JointSample sample;
        sample.time_ns = now_ns;
        sample.sourceTime_s = 1e-9 * static_cast<double>(now_ns);
        sample.angle_rad = sample.reference_rad = kLookingDown_rad;
        (void)arm->push(sample);
        if (!padSilent) {
            core::SampleBlock block;
            block.firstFrame = frames++;
            block.channels = core::ArrayLayout{}.taxels();
            block.time_ns = {now_ns};
            block.sourceTime_s = {sample.sourceTime_s};
            block.values.assign(block.channels, 0.0F);
            (void)array->blocks().push(std::move(block));
        }
        (void)channel->process();
        (void)channel->skin()->update();
        (void)servo->tick(now_ns, held, stopped, false);
    }
    void tickFor(int ticks, bool held) {
        for (int i = 0; i < ticks; ++i)
            tick(held);
    }
    [[nodiscard]] int motions() const {
        return static_cast<int>(std::ranges::count_if(arm->commands, [](const core::ArmCommand& command) {
            return std::ranges::any_of(command.rate_radPerS, [](double rate) { return rate != 0.0; });
        }));
    }

    std::shared_ptr<const arm_model::SerialChain> chain =
        teleta::test::chainOf("resources/arms/seven-joints.urdf");
    PaddedArm* arm = nullptr; // both are owned by the channel
    teleta::test::ScriptedSource* array = nullptr;
    std::shared_ptr<pipeline::ArmChannel> channel;
    std::unique_ptr<ChannelServo> servo;
    std::int64_t now_ns = 1'000'000'000;
    std::uint64_t frames = 0;
    bool padSilent = false;
};

TEST_F(ChannelServoTest, theSecondPressPostsToTheArmAndLettingGoPostsZeroOnce) {
    open();
    servo = *ChannelServo::open(channel);
    tickFor(10, false);
    tickFor(60, true);
    tickFor(3, false);
    EXPECT_TRUE(arm->commands.empty()) << "a rehearsal";
    ASSERT_EQ(servo->servo().stage(), Stage::rehearsed);

    tickFor(30, true);
    EXPECT_EQ(servo->servo().stage(), Stage::driving);
    ASSERT_GT(motions(), 20);
    EXPECT_EQ(arm->commands.back().time_ns, now_ns);
    // The pad goes along its normal, at the speed of the approach.
    const auto pad = *PadArm::create(chain, channel->description(), *channel->pad());
    JointVector later_rad = kLookingDown_rad;
    for (std::size_t i = 0; i < later_rad.size(); ++i)
        later_rad[i] += 1e-3 * arm->commands.back().rate_radPerS[i];
    const Eigen::Isometry3d before = pad->X_Base_Sensor(kLookingDown_rad);
    const Eigen::Vector3d way_m =
        before.linear().transpose() * (pad->X_Base_Sensor(later_rad).translation() - before.translation());
    const double speed_mPerS = servo->servo().plan().tasks.front().feedForward.constant_Sensor[servo::kZ];
    EXPECT_NEAR(way_m.z(), 1e-3 * speed_mPerS, 1e-9);
    EXPECT_LT(way_m.head<2>().norm(), 1e-9);

    const std::size_t posted = arm->commands.size();
    tickFor(30, false);
    ASSERT_EQ(arm->commands.size(), posted + 1);
    EXPECT_EQ(arm->commands.back().rate_radPerS, JointVector::zeros(7));
}

TEST_F(ChannelServoTest, stopAndASilentPadAndWhatTheArmSaysEndIt) {
    for (int way = 0; way < 4; ++way) {
        open();
        servo = *ChannelServo::open(channel);
        tickFor(10, false);
        tickFor(60, true);
        tickFor(3, false);
        tickFor(30, true);
        const int before = motions();
        ASSERT_GT(before, 0);
        if (way == 0)
            tick(true, true);
        if (way == 1)
            arm->driven = core::ArmDrive::stopped;
        if (way == 2)
            arm->inTheWay = "somebody else controls it";
        padSilent = way == 3;
        tickFor(5, true); // 165 ms without a frame
        const int ended = motions();
        EXPECT_LE(ended - before, way == 3 ? 4 : 0) << way;
        arm->driven = core::ArmDrive::held;
        arm->inTheWay.clear();
        padSilent = false;
        tickFor(30, true);
        EXPECT_EQ(motions(), ended) << way;
        EXPECT_EQ(servo->servo().stage(), Stage::idle) << way;
    }
}

TEST_F(ChannelServoTest, whatCannotBeMovedOrDoesNotTellNewtonsIsRefused) {
    open("counts");
    EXPECT_FALSE(ChannelServo::open(channel));
    open("N", true);
    EXPECT_FALSE(ChannelServo::open(channel));
    open();
    EXPECT_TRUE(ChannelServo::open(channel));
}

} // namespace
} // namespace teleta::arm_servo
