// SPDX-License-Identifier: GPL-3.0-or-later
// The mover with given times, on an arm of two joints that is where it was told to be unless a test says
// otherwise. Expected values are closed forms of its limits: 3 rad/s2, 6 rad/s2 with STOP.
#include "backend/arm_model/urdf_reader.h"
#include "devices/ros/trajectory_mover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace teleta::ros_arm {
namespace {

using arm_model::MotionLimits;
using arm_model::TrajectoryPoint;
using Points = std::array<TrajectoryPoint, 2>;

constexpr std::int64_t kPeriod = 20'000'000;
constexpr std::int64_t kMs = 1'000'000;

std::shared_ptr<const arm_model::SerialChain> twoJoints() {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/tests/data/urdf/gripper.urdf");
    EXPECT_TRUE(model);
    const auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                      "base_link", "tool0");
    EXPECT_TRUE(chain);
    return std::make_shared<const arm_model::SerialChain>(*chain);
}

MotionLimits limits() {
    MotionLimits limits;
    limits.effortStop_Nm = {5.0, 5.0};
    limits.speedScale = 1.0;
    limits.tipSpeed_mPerS = 100.0;
    limits.tipTurn_radPerS = 100.0;
    return limits;
}

class MovedArm {
public:
    std::optional<Points> step() {
        input.now_ns += kPeriod;
        if (known)
            input.reading = arm_model::MotionReading{position, effort, {}};
        else
            input.reading.reset();
        const std::optional<Points> points = mover.step(input);
        if (points && follows)
            position = mover.state().commanded;
        return points;
    }
    void letGo() { mover.post({{0.0, 0.0}, input.now_ns + 1}, input.now_ns + 1); }
    void press(double rate = 0.3) { mover.post({{rate, 0.0}, input.now_ns + 2}, input.now_ns + 2); }
    /// Steps with the switch held.
    std::optional<Points> hold(int steps, double rate = 0.3) {
        std::optional<Points> points;
        for (int i = 0; i < steps; ++i) {
            press(rate);
            points = step();
        }
        return points;
    }
    /// Holds the switch until the arm moves at full speed.
    void moveFreshly() {
        step();
        letGo();
        step();
        ASSERT_TRUE(hold(20));
        ASSERT_NEAR(mover.state().rate[0], 0.3, 1e-12);
    }
    bool staysWhenHeld() {
        for (int i = 0; i < 20; ++i) {
            if (hold(1))
                return false;
        }
        return mover.state().drive != core::ArmDrive::jog;
    }

    TrajectoryMover mover{twoJoints(), limits(), kPeriod, arm_model::kFirstPoint_s};
    MoverInput input{.now_ns = 1'000'000'000,
                     .stopped = false,
                     .engagements = 0,
                     .ready = true,
                     .reading = {},
                     .trouble = {}};
    core::JointVector position{0.1, -0.2};
    core::JointVector effort;
    bool known = true;
    bool follows = true;
};

} // namespace

TEST(TrajectoryMover, sendsNothingBeforeASwitchWasLetGoAndPressed) {
    MovedArm arm;
    EXPECT_FALSE(arm.step());
    // Held since before the arm was opened.
    EXPECT_TRUE(arm.staysWhenHeld());
    EXPECT_TRUE(arm.mover.state().needsRelease);
    EXPECT_TRUE(arm.mover.state().ignoresPress);
    arm.letGo();
    EXPECT_FALSE(arm.step());
    EXPECT_FALSE(arm.mover.state().needsRelease);
    EXPECT_FALSE(arm.mover.state().ignoresPress);
    const std::optional<Points> points = arm.hold(1);
    ASSERT_TRUE(points);
    EXPECT_EQ(arm.mover.state().drive, core::ArmDrive::jog);
    EXPECT_FALSE(arm.mover.state().ignoresPress);
    // From where the arm is, with what 3 rad/s2 allow in 20 ms.
    const double v = 3.0 * 0.02;
    const double q = 0.1 + v * 0.02;
    EXPECT_NEAR(points->at(0).time_s, 0.04, 1e-12);
    EXPECT_NEAR(points->at(0).position[0], q + v * 0.04, 1e-12);
    EXPECT_NEAR(points->at(0).velocity[0], v, 1e-12);
    EXPECT_NEAR(points->at(1).time_s, 0.04 + v / 3.0, 1e-12);
    EXPECT_NEAR(points->at(1).position[0], q + v * 0.04 + v * v / 6.0, 1e-12);
    EXPECT_EQ(points->at(1).velocity, core::JointVector::zeros(2));
    EXPECT_EQ(points->at(1).position[1], -0.2);
}

TEST(TrajectoryMover, brakesWhenTheSwitchIsLetGoAndThenIsSilent) {
    MovedArm arm;
    arm.moveFreshly();
    arm.letGo();
    // 0.3 rad/s at 3 rad/s2: five steps, the last of which is at rest.
    for (int i = 1; i <= 5; ++i) {
        ASSERT_TRUE(arm.step()) << i;
        EXPECT_NEAR(arm.mover.state().rate[0], 0.3 - 0.06 * i, 1e-12);
    }
    EXPECT_FALSE(arm.step());
    EXPECT_EQ(arm.mover.state().drive, core::ArmDrive::held);
    // The next press needs nothing more.
    EXPECT_TRUE(arm.hold(1));
}

TEST(TrajectoryMover, brakesWithoutARequiredDeviceAndWantsANewPressAfterIt) {
    MovedArm arm;
    arm.moveFreshly();
    arm.input.lacking = true;
    for (int i = 1; i <= 5; ++i) {
        ASSERT_TRUE(arm.hold(1)) << i;
        EXPECT_NEAR(arm.mover.state().rate[0], 0.3 - 0.06 * i, 1e-12);
    }
    EXPECT_TRUE(arm.staysWhenHeld());
    arm.input.lacking = false;
    EXPECT_TRUE(arm.staysWhenHeld());
    EXPECT_TRUE(arm.mover.state().ignoresPress);
    arm.letGo();
    arm.step();
    EXPECT_TRUE(arm.hold(1));
}

TEST(TrajectoryMover, brakesWhenCommandsStopComing) {
    MovedArm arm;
    arm.moveFreshly();
    // The last command is 20 ms old at the first step of these; it counts for 100 ms.
    for (int i = 0; i < 4; ++i)
        ASSERT_TRUE(arm.step());
    EXPECT_NEAR(arm.mover.state().rate[0], 0.3, 1e-12);
    for (int i = 1; i <= 5; ++i) {
        ASSERT_TRUE(arm.step()) << i;
        EXPECT_NEAR(arm.mover.state().rate[0], 0.3 - 0.06 * i, 1e-12);
    }
    EXPECT_FALSE(arm.step());
    // A short silence of the link does not end the press ...
    EXPECT_TRUE(arm.hold(1));
    // ... one of more than half a second does.
    for (int i = 0; i < 26; ++i)
        (void)arm.step();
    EXPECT_TRUE(arm.staysWhenHeld());
    arm.letGo();
    EXPECT_TRUE(arm.hold(2));
}

TEST(TrajectoryMover, stopBrakesHarderAndAsksForAFreshPress) {
    MovedArm arm;
    arm.moveFreshly();
    arm.input.stopped = true;
    arm.input.engagements = 1;
    const std::optional<Points> points = arm.hold(1);
    ASSERT_TRUE(points);
    EXPECT_EQ(arm.mover.state().drive, core::ArmDrive::stopped);
    EXPECT_NEAR(arm.mover.state().rate[0], 0.18, 1e-12);
    EXPECT_NEAR(points->at(1).time_s, 0.04 + 0.18 / 6.0, 1e-12);
    (void)arm.hold(2);
    EXPECT_NEAR(arm.mover.state().rate[0], 0.0, 1e-12);
    EXPECT_TRUE(arm.staysWhenHeld());
    // Let go while STOP is engaged does not count.
    arm.letGo();
    EXPECT_TRUE(arm.staysWhenHeld());
    arm.input.stopped = false;
    EXPECT_TRUE(arm.staysWhenHeld());
    arm.letGo();
    EXPECT_TRUE(arm.hold(2));
}

TEST(TrajectoryMover, aStopBetweenTwoStepsIsNotMissed) {
    MovedArm arm;
    arm.moveFreshly();
    arm.input.engagements = 1;
    (void)arm.hold(10);
    EXPECT_EQ(arm.mover.state().rate, core::JointVector::zeros(2));
    EXPECT_TRUE(arm.staysWhenHeld());
}

TEST(TrajectoryMover, aFaultEndsCommandsUntilItsCauseIsGone) {
    for (const ArmFaultKind kind :
         {ArmFaultKind::otherWriter, ArmFaultKind::notFinite, ArmFaultKind::jumped, ArmFaultKind::backward}) {
        MovedArm arm;
        arm.moveFreshly();
        arm.input.trouble = ArmFault{kind, "x"};
        EXPECT_FALSE(arm.hold(1));
        EXPECT_EQ(arm.mover.state().fault, (ArmFault{kind, "x"}));
        EXPECT_EQ(arm.mover.state().drive, core::ArmDrive::held);
        arm.letGo();
        EXPECT_TRUE(arm.staysWhenHeld());
        arm.input.trouble.reset();
        EXPECT_TRUE(arm.staysWhenHeld());
        EXPECT_TRUE(arm.mover.state().fault);
        arm.letGo();
        EXPECT_TRUE(arm.hold(2));
        EXPECT_FALSE(arm.mover.state().fault);
    }
}

TEST(TrajectoryMover, nothingIsSentWhileTheArmIsNotKnownOrNobodyListens) {
    MovedArm arm;
    arm.moveFreshly();
    arm.known = false;
    EXPECT_FALSE(arm.hold(1));
    arm.known = true;
    EXPECT_TRUE(arm.staysWhenHeld());
    arm.letGo();
    EXPECT_TRUE(arm.hold(2));
    arm.input.ready = false;
    EXPECT_FALSE(arm.hold(1));
    arm.input.ready = true;
    EXPECT_TRUE(arm.staysWhenHeld());
}

TEST(TrajectoryMover, aLateStepDoesNotGoOnWhereTheArmHasStopped) {
    MovedArm arm;
    arm.moveFreshly();
    arm.input.now_ns += 101 * kMs;
    EXPECT_FALSE(arm.hold(1));
    EXPECT_TRUE(arm.staysWhenHeld());
    // One that is a little late moves no farther than the first point of the command before it.
    arm.letGo();
    (void)arm.hold(20);
    const double before = arm.mover.state().commanded[0];
    arm.input.now_ns += 60 * kMs;
    ASSERT_TRUE(arm.hold(1));
    EXPECT_NEAR(arm.mover.state().commanded[0] - before, 0.3 * 0.04, 1e-12);
}

TEST(TrajectoryMover, anArmThatDoesNotFollowIsAFault) {
    MovedArm arm;
    arm.follows = false;
    arm.step();
    arm.letGo();
    arm.step();
    // The leash of 0.05 rad is reached, and 0.3 s later the arm counts as stuck.
    double farthest = 0.0;
    int steps = 0;
    for (; steps < 100 && !arm.mover.state().fault; ++steps) {
        (void)arm.hold(1);
        farthest = std::max(farthest, std::abs(arm.mover.state().commanded[0] - 0.1));
    }
    EXPECT_LE(farthest, 0.05 + 1e-12);
    ASSERT_TRUE(arm.mover.state().fault);
    EXPECT_EQ(arm.mover.state().fault->kind, ArmFaultKind::notFollowing);
    EXPECT_TRUE(arm.staysWhenHeld());
}

TEST(TrajectoryMover, aRiseOfTheEffortHoldsTheArmUntilAFreshPress) {
    MovedArm arm;
    arm.effort = {12.0, 1.0};
    for (int i = 0; i < 30; ++i)
        (void)arm.step();
    arm.moveFreshly();
    arm.effort = {18.0, 1.0};
    // Said in the same step, so that nobody who looks between two steps misses it.
    (void)arm.hold(1);
    EXPECT_TRUE(arm.mover.state().ignoresPress);
    (void)arm.hold(5);
    EXPECT_NEAR(arm.mover.state().rate[0], 0.0, 1e-12);
    EXPECT_TRUE(arm.mover.state().needsRelease);
    // Longer than efforts at rest are averaged: the arm does not press on.
    const double where = arm.mover.state().commanded[0];
    (void)arm.hold(60);
    EXPECT_EQ(arm.mover.state().commanded[0], where);
    arm.letGo();
    EXPECT_TRUE(arm.hold(2, -0.3));
}

TEST(TrajectoryMover, commandsThatAreNotFiniteOrOfAnotherArmMoveNothing) {
    MovedArm arm;
    arm.step();
    arm.letGo();
    arm.step();
    (void)arm.hold(5, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(arm.mover.state().rate, core::JointVector::zeros(2));
    EXPECT_NE(arm.mover.state().flags & static_cast<std::uint32_t>(arm_model::MotionFlag::notFinite), 0U);
    arm.mover.post({{0.1, 0.1, 0.1}, arm.input.now_ns + 2}, arm.input.now_ns + 2);
    (void)arm.step();
    EXPECT_EQ(arm.mover.state().rate, core::JointVector::zeros(2));
    // A reading of another arm.
    arm.position = core::JointVector{0.1, 0.2, 0.3};
    EXPECT_FALSE(arm.hold(1));
}

TEST(TrajectoryMover, aCommandOfTheFutureCountsAsGivenNow) {
    MovedArm arm;
    arm.step();
    arm.letGo();
    arm.step();
    arm.mover.post({{0.3, 0.0}, std::numeric_limits<std::int64_t>::max()}, arm.input.now_ns + 1);
    int moving = 0;
    while (arm.step() && moving < 100)
        ++moving;
    // 100 ms of motion up to 0.3 rad/s and as long to brake.
    EXPECT_LE(moving, 11);
    EXPECT_GE(moving, 5);
}

} // namespace teleta::ros_arm
