// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/touch_estimator.h"
#include "tests/backend/pipeline/scripted_arm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

using namespace teleta;
using pipeline::TouchEstimator;
using pipeline::TouchEstimatorSettings;
using pipeline::TouchRecord;
using test::paperArm;
using test::ScriptedArm;

namespace {

/// The record of a touch of 1325.9 N/m in which the elbow's torque rises to this one and stays there.
std::optional<TouchRecord> touch(const core::ArmDescription& description, double elbow_Nm) {
    ScriptedArm arm(0.175, std::numbers::pi, 1325.9);
    TouchEstimatorSettings settings;
    settings.elbowWait_s = 0.2;
    TouchEstimator estimator(description, settings);
    std::optional<TouchRecord> record;
    const auto step = [&](double force_N) {
        if (auto made = estimator.update(arm.next(force_N)))
            record = made;
        if (auto made = estimator.update(arm.skin(std::abs(force_N) > 0.05 ? std::abs(force_N) : 0.0)))
            record = made;
    };
    for (int i = 0; i < 100; ++i)
        step(0.0);
    for (int i = 0; i <= 200; ++i)
        step(arm.forceFor_N(elbow_Nm * i / 200.0));
    for (int i = 0; i < 400; ++i)
        step(arm.forceFor_N(elbow_Nm));
    return record;
}

} // namespace

TEST(ElbowShare, theTwistOfTheShoulderIsTakenOffTheObjectsCompliance) {
    // The scripted arm's shoulder is rigid; told that it yields, the estimator takes its compliance d^2/K
    // off, with the depth d that an angle of its pitch presses: at most the distance of the contact from the
    // shoulder.
    constexpr double kShoulder_NmPerRad = 1e4;
    core::ArmDescription yielding = paperArm();
    yielding.shoulderStiffness_NmPerRad = {0.0, kShoulder_NmPerRad, 0.0};
    const auto rigid = touch(paperArm(), 0.08);
    const auto soft = touch(yielding, 0.08);
    ASSERT_TRUE(rigid && rigid->stiffness && rigid->stiffness->object.value_NPerM);
    ASSERT_TRUE(soft && soft->stiffness && soft->stiffness->object.value_NPerM);
    EXPECT_NEAR(*rigid->stiffness->object.value_NPerM, 1325.9, 1e-6 * 1325.9);

    arm::JointVector angle_rad;
    ScriptedArm arm(0.175, std::numbers::pi, 1325.9);
    const core::JointSample pose = arm.next(0.0); // the touch turns it by a few thousandths more
    angle_rad << pose.angle_rad[0], pose.angle_rad[1], pose.angle_rad[2], pose.angle_rad[3];
    const arm::Arm4Kinematics kinematics({.upperArmLength_m = yielding.upperArmLength_m,
                                          .forearmLength_m = yielding.forearmLength_m,
                                          .halfThickness_m = yielding.halfThickness_m});
    const Eigen::Vector3d p_Link = kinematics.p_Link_Skin(0.175, std::numbers::pi);
    const Eigen::Vector3d normal = kinematics.X_Base_Link(arm::Link::forearm, angle_rad).linear() *
                                   -Eigen::Vector3d::UnitZ(); // of the skin at that side
    const double depth_m =
        (kinematics.pointJacobian(arm::Link::forearm, angle_rad, p_Link).transpose() * normal)[1];
    const double taken_mPerN =
        1.0 / *rigid->stiffness->object.value_NPerM - 1.0 / *soft->stiffness->object.value_NPerM;
    EXPECT_NEAR(taken_mPerN, depth_m * depth_m / kShoulder_NmPerRad, 1e-2 * taken_mPerN);
}

TEST(ElbowShare, anElbowThatBearsLittleTellsNoStiffness) {
    // In the lower half of the window, while the shoulder is over the threshold.
    const auto record = touch(paperArm(), 0.03);
    ASSERT_TRUE(record);
    EXPECT_FALSE(record->stiffness);
    EXPECT_EQ(record->refusal, stiffness::Refusal::windowNotReached);
}
