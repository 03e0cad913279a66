// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/contact_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace teleta::arm;
using Eigen::Vector3d;

namespace {

constexpr double kRightAngle_rad = std::numbers::pi / 2.0;
const Arm4Kinematics kArm({0.3, 0.25, 0.03});

ContactForce solve(const PointJacobian& jacobian, const JointVector& torque_Nm,
                   const ForceSettings& settings = {}) {
    return solveContactForce(jacobian, torque_Nm, settings).value();
}

/// Force found again from the torques that it makes.
ContactForce roundTrip(Link link, const JointVector& q_rad, const Vector3d& point, const Vector3d& force_N) {
    const PointJacobian jacobian = kArm.pointJacobian(link, q_rad, point);
    return solve(jacobian, jacobian.transpose() * force_N);
}

} // namespace

TEST(ContactForce, bentElbowShowsAllThreeComponents) {
    const Vector3d force_N(1.5, -2.0, 3.0);
    const ContactForce contact =
        roundTrip(Link::forearm, {0.2, -0.4, 0.3, kRightAngle_rad}, {0.17, 0.0, 0.0}, force_N);
    EXPECT_LE((contact.force_N - force_N).norm(), 1e-13);
    EXPECT_EQ(contact.observedDirections, 3);
    EXPECT_TRUE(contact.observable[0] && contact.observable[1] && contact.observable[2]);
    EXPECT_LE(contact.residual_Nm, 1e-14);
    EXPECT_LE(contact.hidden.norm(), 0.0);
}

TEST(ContactForce, torquesOfAKnownPoseAreThoseOfTheLevers) {
    // Elbow at a right angle: contact 0.3 m ahead, 0.17 m below. 1 N along x turns pitch and elbow by -0.17 m
    // each, along z turns pitch by -0.3 m, along y turns roll by 0.17 m and yaw by 0.3 m.
    const PointJacobian jacobian =
        kArm.pointJacobian(Link::forearm, {0.0, 0.0, 0.0, kRightAngle_rad}, {0.17, 0.0, 0.0});
    const ContactForce x = solve(jacobian, {0.0, -0.17, 0.0, -0.17});
    EXPECT_LE((x.force_N - Vector3d::UnitX()).norm(), 1e-13);
    const ContactForce y = solve(jacobian, {0.17, 0.0, 0.3, 0.0});
    EXPECT_LE((y.force_N - Vector3d::UnitY()).norm(), 1e-13);
    const ContactForce z = solve(jacobian, {0.0, -0.3, 0.0, 0.0});
    EXPECT_LE((z.force_N - Vector3d::UnitZ()).norm(), 1e-13);
    EXPECT_NEAR(y.levers_m[0] * y.levers_m[2] > 0.0 ? y.conditionNumber : 0.0, y.levers_m[0] / y.levers_m[2],
                1e-12);
}

TEST(ContactForce, conditionNumberIsTheRatioOfTheLevers) {
    // J J^T of the pose above is blockwise: y has 0.17^2 + 0.3^2; x, z have [2 a^2, a b; a b, b^2] with a, b
    // as there.
    const PointJacobian jacobian =
        kArm.pointJacobian(Link::forearm, {0.0, 0.0, 0.0, kRightAngle_rad}, {0.17, 0.0, 0.0});
    const ContactForce contact = solve(jacobian, JointVector::Zero());
    const double a2 = 0.17 * 0.17;
    const double b2 = 0.3 * 0.3;
    const double middle = 0.5 * (2.0 * a2 + b2);
    const double root = std::sqrt(middle * middle - a2 * b2);
    const double largest = std::max(middle + root, a2 + b2);
    EXPECT_NEAR(contact.conditionNumber, std::sqrt(largest / (middle - root)), 1e-12);
}

TEST(ContactForce, stretchedArmHidesTheForceAlongItself) {
    // Elbow angle 0, contact on the centre line: no joint has a lever for the force along x.
    const ContactForce contact =
        roundTrip(Link::forearm, JointVector::Zero(), {0.17, 0.0, 0.0}, Vector3d(5.0, 1.0, -2.0));
    EXPECT_FALSE(contact.observable[0]);
    EXPECT_TRUE(contact.observable[1] && contact.observable[2]);
    EXPECT_LE((contact.force_N - Vector3d(0.0, 1.0, -2.0)).norm(), 1e-13);
    EXPECT_EQ(contact.observedDirections, 2);
    EXPECT_NEAR(contact.hidden(0, 0), 1.0, 1e-14);
    EXPECT_TRUE(std::isinf(contact.conditionNumber) || contact.conditionNumber > 1e14);
}

TEST(ContactForce, stretchedArmThatPointsAnywhereHidesTheDirectionOfTheArm) {
    const JointVector q_rad(0.7, -0.5, 0.9, 0.0);
    const Vector3d along = kArm.X_Base_Link(Link::forearm, q_rad).linear().col(0);
    const Vector3d force_N(1.0, 2.0, 3.0);
    const ContactForce contact = roundTrip(Link::forearm, q_rad, {0.17, 0.0, 0.0}, force_N);
    EXPECT_LE((contact.hidden - along * along.transpose()).norm(), 1e-13);
    EXPECT_LE((contact.force_N - (force_N - along * along.dot(force_N))).norm(), 1e-12);
    EXPECT_FALSE(contact.observable[0] || contact.observable[1] || contact.observable[2])
        << "every axis has a part along the arm";
}

TEST(ContactForce, skinOfTheStretchedArmGivesTheFrictionAlongItAShortLever) {
    // 30 mm off the centre line the force along the arm turns pitch and elbow alike; a force across turns
    // them by different levers, so both are found.
    const Vector3d force_N(0.5, 1.0, -2.0);
    const ContactForce contact =
        roundTrip(Link::forearm, JointVector::Zero(), kArm.p_Link_Skin(0.17, 0.0), force_N);
    EXPECT_LE((contact.force_N - force_N).norm(), 1e-12);
    EXPECT_EQ(contact.observedDirections, 3);
    EXPECT_GT(contact.forceSd_N[0], 5.0 * contact.forceSd_N[2]);
}

TEST(ContactForce, contactOnTheElbowAxisHidesTheForceAlongTheUpperArm) {
    const ContactForce contact = roundTrip(Link::forearm, {0.0, 0.0, 0.0, kRightAngle_rad}, Vector3d::Zero(),
                                           Vector3d(5.0, 1.0, -2.0));
    EXPECT_FALSE(contact.observable[0]);
    EXPECT_LE((contact.force_N - Vector3d(0.0, 1.0, -2.0)).norm(), 1e-13);
}

TEST(ContactForce, contactOnTheUpperArmHidesTheForceAlongIt) {
    const ContactForce contact =
        roundTrip(Link::upperArm, {0.0, 0.0, 0.0, 1.0}, {0.2, 0.0, 0.0}, Vector3d(5.0, 1.0, -2.0));
    EXPECT_EQ(contact.observedDirections, 2);
    EXPECT_LE((contact.force_N - Vector3d(0.0, 1.0, -2.0)).norm(), 1e-13);
}

TEST(ContactForce, contactAtTheShoulderShowsNothing) {
    const PointJacobian jacobian = kArm.pointJacobian(Link::upperArm, {0.4, 0.5, 0.6, 0.7}, Vector3d::Zero());
    const ContactForce contact = solve(jacobian, {0.001, -0.002, 0.0005, 0.0});
    EXPECT_EQ(contact.observedDirections, 0);
    EXPECT_EQ(contact.force_N.norm(), 0.0) << "noise is not shown as force";
    EXPECT_EQ(contact.forceSd_N.norm(), 0.0);
    EXPECT_FALSE(contact.observable[0] || contact.observable[1] || contact.observable[2]);
    EXPECT_TRUE(std::isinf(contact.conditionNumber));
    EXPECT_LE((contact.hidden - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

TEST(ContactForce, standardDeviationsAreThoseOfNoisyTorques) {
    const PointJacobian jacobian =
        kArm.pointJacobian(Link::forearm, {0.2, -0.4, 0.3, 1.1}, kArm.p_Link_Skin(0.17, 0.5));
    const Vector3d force_N(1.0, -2.0, 0.5);
    const JointVector torque_Nm = jacobian.transpose() * force_N;
    std::mt19937_64 random(8);
    std::normal_distribution<double> normal(0.0, 0.0005);
    constexpr int kRuns = 20000;
    Vector3d squares = Vector3d::Zero();
    for (int run = 0; run < kRuns; ++run) {
        const JointVector noise_Nm(normal(random), normal(random), normal(random), normal(random));
        squares += (solve(jacobian, torque_Nm + noise_Nm).force_N - force_N).cwiseAbs2();
    }
    const Vector3d expected = solve(jacobian, torque_Nm).forceSd_N;
    const Vector3d measured = (squares / kRuns).cwiseSqrt();
    for (int axis = 0; axis < 3; ++axis) // 1/sqrt(2 x 20000) = 0.5 %; four of them
        EXPECT_NEAR(measured[axis], expected[axis], 0.02 * expected[axis]) << axis;
}

TEST(ContactForce, torquesThatNoForceExplainsAreTheResidual) {
    // The four torques span more than three forces can make; the rest is orthogonal to all of them.
    const PointJacobian jacobian =
        kArm.pointJacobian(Link::forearm, {0.0, 0.0, 0.0, kRightAngle_rad}, {0.17, 0.0, 0.0});
    const JointVector unexplained = JointVector(0.3, 0.0, -0.17, 0.0).normalized() * 0.02;
    const ContactForce contact =
        solve(jacobian, jacobian.transpose() * Vector3d(1.0, 1.0, 1.0) + unexplained);
    EXPECT_LE((contact.force_N - Vector3d::Ones()).norm(), 1e-13);
    EXPECT_NEAR(contact.residual_Nm, 0.02, 1e-14);
}

TEST(ContactForce, refusesBadSettings) {
    const PointJacobian jacobian = PointJacobian::Ones();
    EXPECT_EQ(solveContactForce(jacobian, JointVector::Ones(), {0.0005, 0.0}).error(),
              ForceRefusal::badSetting);
    EXPECT_EQ(solveContactForce(jacobian, JointVector::Ones(), {-0.0005, 0.01}).error(),
              ForceRefusal::badSetting);
}
