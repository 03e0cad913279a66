// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/motion_limits.h"
#include "backend/arm_model/urdf_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

using namespace teleta;
using namespace teleta::arm_model;

namespace {

constexpr double kStep_s = 0.02;
constexpr double kReaction_s = 0.04;

/// Shoulder -3..3 rad at 2 rad/s, elbow -2..2 rad at 3 rad/s; links of 0.3 and 0.2 m.
std::shared_ptr<const SerialChain> planarArm() {
    const auto model = readUrdf(TELETA_SOURCE_DIR "/tests/data/urdf/gripper.urdf");
    EXPECT_TRUE(model) << core::describe(model.error());
    const auto chain = SerialChain::create(std::make_shared<const ArmModel>(*model), "base_link", "tool0");
    EXPECT_TRUE(chain) << core::describe(chain.error());
    return std::make_shared<const SerialChain>(*chain);
}

/// Limits that let everything through but what a test looks at.
MotionLimits wide() {
    MotionLimits limits;
    limits.speedScale = 1.0;
    limits.tipSpeed_mPerS = 100.0;
    limits.tipTurn_radPerS = 100.0;
    return limits;
}

/// An arm that is always where it was told to be.
class Follower {
public:
    explicit Follower(const MotionLimits& limits,
                      const core::JointVector& start = core::JointVector::zeros(2))
        : m_governor(planarArm(), limits, kReaction_s) {
        m_governor.reset(start);
        m_last.commanded = start;
    }

    MotionStep step(const MotionDemand& demand, MotionReading reading = {}) {
        reading.position = m_last.commanded;
        m_last = m_governor.step(demand, reading, kStep_s);
        return m_last;
    }
    MotionStep run(const MotionDemand& demand, int steps) {
        for (int i = 0; i < steps; ++i)
            step(demand);
        return m_last;
    }

private:
    MotionGovernor m_governor;
    MotionStep m_last;
};

} // namespace

TEST(MotionLimits, slowAllJointsDownAlikeToTheFastestOfOne) {
    MotionLimits limits = wide();
    limits.speedScale = 0.25; // 0.5 and 0.75 rad/s
    Follower arm(limits);
    const MotionStep step = arm.run({{2.0, 1.0}}, 20);
    EXPECT_NEAR(step.rate[0], 0.5, 1e-12);
    EXPECT_NEAR(step.rate[1], 0.25, 1e-12);
    EXPECT_TRUE(step.has(MotionFlag::jointRate));
}

TEST(MotionLimits, accelerateAndBrakeAsTold) {
    Follower arm(wide());
    EXPECT_NEAR(arm.step({{0.3, 0.0}}).rate[0], 3.0 * kStep_s, 1e-12);
    EXPECT_NEAR(arm.run({{0.3, 0.0}}, 10).rate[0], 0.3, 1e-12);
    // Let go: 0.3 rad/s at 3 rad/s2 take 5 steps; with STOP at 6 rad/s2 they take 3.
    EXPECT_NEAR(arm.step({}).rate[0], 0.24, 1e-12);
    EXPECT_NEAR(arm.run({}, 4).rate[0], 0.0, 1e-12);
    arm.run({{0.3, 0.0}}, 10);
    EXPECT_NEAR(arm.step({{0.3, 0.0}, true}).rate[0], 0.18, 1e-12);
    EXPECT_NEAR(arm.run({{0.3, 0.0}, true}, 2).rate[0], 0.0, 1e-12);
}

TEST(MotionLimits, keepTheSpeedOfTheTip) {
    MotionLimits limits = wide();
    limits.tipSpeed_mPerS = 0.1;
    Follower arm(limits);
    // Stretched, the shoulder moves the tip on a radius of 0.5 m.
    const MotionStep step = arm.run({{1.0, 0.0}}, 20);
    EXPECT_NEAR(step.rate[0], 0.2, 1e-9);
    EXPECT_TRUE(step.has(MotionFlag::tipSpeed));
    limits = wide();
    limits.tipTurn_radPerS = 0.5;
    Follower turning(limits);
    EXPECT_NEAR(turning.run({{1.0, 1.0}}, 20).rate[0], 0.25, 1e-9);
}

TEST(MotionLimits, comeToRestBeforeTheEndOfAJoint) {
    Follower arm(wide());
    double farthest = 0.0;
    for (int i = 0; i < 400; ++i) {
        const MotionStep step = arm.step({{0.0, 3.0}});
        // If this is the last command, the arm goes on for the reaction time and brakes at 3 rad/s2.
        const double v = step.rate[1];
        farthest = std::max(farthest, step.commanded[1] + v * kReaction_s + v * v / 6.0);
    }
    EXPECT_LE(farthest, 2.0 - 0.05 + 1e-12);
    EXPECT_GT(farthest, 2.0 - 0.05 - 1e-3);
}

TEST(MotionLimits, letAJointBeyondItsEndMoveBackOnly) {
    Follower arm(wide(), {0.0, 2.2});
    const MotionStep out = arm.run({{0.0, 0.5}}, 10);
    EXPECT_EQ(out.commanded[1], 2.2);
    EXPECT_TRUE(out.has(MotionFlag::jointEnd));
    EXPECT_LT(arm.run({{0.0, -0.5}}, 10).commanded[1], 2.2);
}

TEST(MotionLimits, keepTheTipInTheBoxFromEveryStateOfABlindRide) {
    MotionLimits limits = wide();
    limits.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(0.1, -1.0, -0.3), Eigen::Vector3d(0.45, 1.0, 0.3));
    const auto chain = planarArm();
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> any(-2.0, 2.0);
    Follower arm(limits, {-0.8, 1.6});
    ASSERT_EQ(limits.box_m->exteriorDistance(chain->X_Base_Tip({-0.8, 1.6}).translation()), 0.0);
    bool touched = false;
    for (int ride = 0; ride < 200; ++ride) {
        const MotionDemand demand{{any(random), any(random)}};
        for (int i = 0; i < 25; ++i) {
            const MotionStep step = arm.step(demand);
            touched = touched || step.has(MotionFlag::workspace);
            core::JointVector rest = step.commanded;
            for (std::size_t k = 0; k < 2; ++k)
                rest[k] += step.rate[k] * kReaction_s + step.rate[k] * std::abs(step.rate[k]) / 6.0;
            EXPECT_LE(limits.box_m->exteriorDistance(chain->X_Base_Tip(rest).translation()), 1e-3);
        }
    }
    EXPECT_TRUE(touched);
}

TEST(MotionLimits, holdWhenTheEffortOfAJointRises) {
    MotionLimits limits = wide();
    limits.effortStop_Nm = {5.0, 5.0};
    Follower arm(limits);
    const MotionReading rest{{}, {12.0, 1.0}, {}};
    for (int i = 0; i < 30; ++i)
        arm.step({}, rest);
    EXPECT_FALSE(arm.step({{0.3, 0.0}}, {{}, {16.0, 1.0}, {}}).has(MotionFlag::effort));
    EXPECT_GT(arm.step({{0.3, 0.0}}, {{}, {16.0, 1.0}, {}}).rate[0], 0.0);
    MotionStep held;
    for (int i = 0; i < 5; ++i)
        held = arm.step({{0.3, 0.0}}, {{}, {18.0, 1.0}, {}});
    EXPECT_TRUE(held.has(MotionFlag::effort));
    EXPECT_EQ(held.rate[0], 0.0);
    // At rest for half a second the new effort is the one of rest.
    for (int i = 0; i < 40; ++i)
        held = arm.step({{0.3, 0.0}}, {{}, {18.0, 1.0}, {}});
    EXPECT_GT(held.rate[0], 0.0);
}

TEST(MotionLimits, anArmThatIsNotCommandedKeepsItsEffortsOfRest) {
    MotionLimits limits = wide();
    limits.effortStop_Nm = {5.0, 5.0};
    MotionGovernor governor(planarArm(), limits, kReaction_s);
    for (int i = 0; i < 30; ++i) {
        governor.restAt({0.01 * i, 0.0});
        const MotionStep step = governor.step({}, {{0.01 * i, 0.0}, {12.0, 1.0}, {}}, kStep_s);
        EXPECT_EQ(step.commanded[0], 0.01 * i);
        EXPECT_FALSE(step.fault);
    }
    EXPECT_TRUE(governor.step({{0.3, 0.0}}, {{0.29, 0.0}, {18.0, 1.0}, {}}, kStep_s).has(MotionFlag::effort));
}

TEST(MotionLimits, letTheArmRetreatFromAForceOnly) {
    MotionLimits limits = wide();
    limits.forceStop_N = 30.0;
    Follower arm(limits); // stretched along x: a positive turn of the shoulder lowers the tip
    const MotionReading pressed{{}, {}, Eigen::Vector3d(0.0, 0.0, 40.0)};
    MotionStep step;
    for (int i = 0; i < 10; ++i)
        step = arm.step({{0.2, 0.0}}, pressed);
    EXPECT_TRUE(step.has(MotionFlag::force));
    EXPECT_EQ(step.rate[0], 0.0);
    for (int i = 0; i < 10; ++i)
        step = arm.step({{-0.2, 0.0}}, pressed);
    EXPECT_LT(step.rate[0], 0.0);
}

TEST(MotionLimits, waitForAnArmThatLagsAndThenFault) {
    MotionGovernor governor(planarArm(), wide(), kReaction_s);
    governor.reset({0.0, 0.0});
    MotionStep step;
    int steps = 0;
    while (!step.fault && steps < 200) {
        step = governor.step({{0.5, 0.0}}, {{0.0, 0.0}, {}, {}}, kStep_s); // stuck
        ++steps;
        EXPECT_LE(step.commanded[0], 0.05 + 1e-12);
    }
    EXPECT_TRUE(step.has(MotionFlag::leash));
    EXPECT_TRUE(step.fault);
    // 0.05 rad at 3 rad/s2 up to 0.5 rad/s take 0.18 s; then 0.3 s on the leash.
    EXPECT_NEAR(steps * kStep_s, 0.18 + 0.3, 0.05);
}

TEST(MotionLimits, demandsAndReadingsThatAreNotFiniteMoveNothing) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    Follower arm(wide());
    EXPECT_TRUE(arm.step({{kNan, 0.1}}).has(MotionFlag::notFinite));
    EXPECT_EQ(arm.run({{kNan, 0.1}}, 5).rate, core::JointVector::zeros(2));
    EXPECT_EQ(arm.run({core::JointVector::zeros(3)}, 5).rate, core::JointVector::zeros(2));
    MotionGovernor governor(planarArm(), wide(), kReaction_s);
    governor.reset({0.1, 0.2});
    const MotionStep step = governor.step({{0.5, 0.0}}, {{kNan, 0.0}, {}, {}}, kStep_s);
    EXPECT_TRUE(step.fault);
    EXPECT_EQ(step.commanded, (core::JointVector{0.1, 0.2}));
}
