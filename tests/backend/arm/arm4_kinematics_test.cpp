// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/arm4_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace teleta::arm;
using Eigen::Vector3d;

namespace {

constexpr double kRightAngle_rad = std::numbers::pi / 2.0;
constexpr double kRounding_m = 1e-15;

void expectNear(const Vector3d& value, const Vector3d& expected, double tolerance) {
    EXPECT_LE((value - expected).cwiseAbs().maxCoeff(), tolerance)
        << value.transpose() << " instead of " << expected.transpose();
}

} // namespace

TEST(Arm4Kinematics, stretchedArmLiesAlongX) {
    const Arm4Kinematics arm({0.3, 0.25, 0.03});
    const JointVector zero = JointVector::Zero();
    expectNear(arm.p_Base_Point(Link::forearm, zero, {0.25, 0.0, 0.0}), {0.55, 0.0, 0.0}, kRounding_m);
    expectNear(arm.p_Base_Point(Link::upperArm, zero, {0.1, 0.02, 0.03}), {0.1, 0.02, 0.03}, kRounding_m);
}

TEST(Arm4Kinematics, eachJointTurnsAboutItsAxis) {
    const Arm4Kinematics arm({0.3, 0.25, 0.03});
    const Vector3d tip(0.25, 0.0, 0.0);
    // Pitch by 90 degrees about y takes x to -z; yaw about z takes x to y; roll about x leaves x, takes y to
    // z.
    expectNear(arm.p_Base_Point(Link::forearm, {0.0, kRightAngle_rad, 0.0, 0.0}, tip), {0.0, 0.0, -0.55},
               kRounding_m);
    expectNear(arm.p_Base_Point(Link::forearm, {0.0, 0.0, kRightAngle_rad, 0.0}, tip), {0.0, 0.55, 0.0},
               kRounding_m);
    expectNear(arm.p_Base_Point(Link::forearm, {kRightAngle_rad, 0.0, kRightAngle_rad, 0.0}, tip),
               {0.0, 0.0, 0.55}, kRounding_m);
    expectNear(arm.p_Base_Point(Link::forearm, {0.0, 0.0, 0.0, kRightAngle_rad}, tip), {0.3, 0.0, -0.25},
               kRounding_m);
    // Roll turns the bent elbow: -z goes to y.
    expectNear(arm.p_Base_Point(Link::forearm, {kRightAngle_rad, 0.0, 0.0, kRightAngle_rad}, tip),
               {0.3, 0.25, 0.0}, kRounding_m);
}

TEST(Arm4Kinematics, jacobianIsTheDerivativeOfThePosition) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> angle(-3.0, 3.0);
    std::uniform_real_distribution<double> coordinate(-0.3, 0.3);
    const Arm4Kinematics arm;
    for (int round = 0; round < 200; ++round) {
        const JointVector q_rad(angle(random), angle(random), angle(random), angle(random));
        const Vector3d point(coordinate(random), coordinate(random), coordinate(random));
        for (const Link link : {Link::upperArm, Link::forearm}) {
            const PointJacobian jacobian = arm.pointJacobian(link, q_rad, point);
            constexpr double kStep_rad = 1e-5;
            for (int joint = 0; joint < 4; ++joint) {
                const JointVector step_rad = kStep_rad * JointVector::Unit(joint);
                const Vector3d difference = (arm.p_Base_Point(link, q_rad + step_rad, point) -
                                             arm.p_Base_Point(link, q_rad - step_rad, point)) /
                                            (2.0 * kStep_rad);
                expectNear(jacobian.col(joint), difference, 1e-10);
            }
        }
    }
}

TEST(Arm4Kinematics, posesAreRotationsAndTheElbowIsAtTheEndOfTheUpperArm) {
    const Arm4Kinematics arm;
    const JointVector q_rad(0.3, -0.7, 1.9, 2.2);
    for (const Link link : {Link::upperArm, Link::forearm}) {
        const Eigen::Matrix3d rotation = arm.X_Base_Link(link, q_rad).linear();
        EXPECT_LE((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
        EXPECT_NEAR(rotation.determinant(), 1.0, 1e-14);
    }
    expectNear(arm.p_Base_Point(Link::forearm, q_rad, Vector3d::Zero()),
               arm.p_Base_Point(Link::upperArm, q_rad, {arm.dimensions().upperArmLength_m, 0.0, 0.0}),
               kRounding_m);
}

TEST(Arm4Kinematics, skinPointLiesOnTheSurface) {
    const Arm4Kinematics arm;
    expectNear(arm.p_Link_Skin(0.175, 0.0), {0.175, 0.0, 0.03}, kRounding_m);
    expectNear(arm.p_Link_Skin(0.175, kRightAngle_rad), {0.175, -0.03, 0.0}, kRounding_m);
    // The paper's r of the aluminium touch, printed with four digits.
    EXPECT_NEAR(arm.p_Link_Skin(0.175, 1.0).norm(), 0.1776, 5e-5);
}
