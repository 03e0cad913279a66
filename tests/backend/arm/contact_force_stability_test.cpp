// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/contact_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace teleta::arm;
using Eigen::Vector3d;

namespace {

tl::expected<ContactForce, ForceRefusal> solve(const PointJacobian& jacobian, const JointVector& torque_Nm,
                                               const ForceSettings& settings = {}) {
    return solveContactForce(jacobian, torque_Nm, settings);
}

} // namespace

TEST(ContactForceStability, elbowTowardsStretchedFadesWithoutAJumpAndNeverAmplifiesNoise) {
    const Arm4Kinematics arm({0.3, 0.25, 0.03});
    const ForceSettings settings;
    const Vector3d truth_N(2.0, 1.0, -1.0);
    const JointVector noise_Nm(0.0005, -0.0005, 0.0005, -0.0005);
    bool hidden = false;
    for (int step = 0; step <= 240; ++step) { // twelve decades, twenty steps each
        const double elbow_rad = std::pow(10.0, -step / 20.0);
        const PointJacobian jacobian =
            arm.pointJacobian(Link::forearm, {0.1, 0.2, 0.3, elbow_rad}, {0.17, 0.0, 0.0});
        const auto clean = solve(jacobian, jacobian.transpose() * truth_N, settings);
        const auto noisy = solve(jacobian, jacobian.transpose() * truth_N + noise_Nm, settings);
        ASSERT_TRUE(clean && noisy);
        EXPECT_LE((noisy->force_N - clean->force_N).norm(), 1.2 * noise_Nm.norm() / settings.leastLever_m);
        EXPECT_LE(clean->force_N.norm(), truth_N.norm() * (1.0 + 1e-12));
        EXPECT_TRUE(clean->forceSd_N.allFinite());
        if (clean->observedDirections == 3) {
            EXPECT_FALSE(hidden) << "hidden once, hidden from there on";
            // Rounding times the condition number.
            EXPECT_LE((clean->force_N - truth_N).norm(), 1e-14 * clean->conditionNumber);
        } else {
            EXPECT_EQ(clean->observedDirections, 2);
            hidden = true;
            // What is not hidden is still right.
            const Vector3d error_N = clean->force_N - truth_N;
            EXPECT_LE((error_N - clean->hidden * error_N).norm(), 1e-12);
        }
    }
    EXPECT_TRUE(hidden);
}

TEST(ContactForceStability, componentBesideTheBorderDoesNotJump) {
    // One lever of its own, moved across the least lever.
    double last_N = 1.0;
    for (int step = 0; step <= 2000; ++step) {
        const double lever_m = 0.02 - 1e-5 * step;
        PointJacobian jacobian = PointJacobian::Zero();
        jacobian(0, 0) = lever_m;
        jacobian(1, 1) = 0.3;
        jacobian(2, 2) = 0.3;
        const auto contact = solve(jacobian, {lever_m, 0.0, 0.0, 0.0});
        ASSERT_TRUE(contact);
        EXPECT_LE(std::abs(contact->force_N[0] - last_N), 0.01);
        EXPECT_EQ(contact->observable[0], lever_m >= 0.01 * (1.0 - 1e-12)) << lever_m;
        last_N = contact->force_N[0];
    }
    EXPECT_NEAR(last_N, 0.0, 1e-12);
}

TEST(ContactForceStability, forceScalesWithTorqueAndLength) {
    const Arm4Kinematics arm;
    const PointJacobian jacobian = arm.pointJacobian(Link::forearm, {0.1, 0.2, 0.3, 0.9}, {0.17, 0.0, 0.03});
    const JointVector torque_Nm(0.1, -0.2, 0.05, 0.02);
    const auto reference = solve(jacobian, torque_Nm);
    ASSERT_TRUE(reference);
    for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
        const auto torque = solve(jacobian, scale * torque_Nm, {0.0005 * scale, 0.01});
        ASSERT_TRUE(torque);
        EXPECT_LE((torque->force_N - scale * reference->force_N).norm(),
                  1e-12 * scale * reference->force_N.norm());
        EXPECT_LE((torque->forceSd_N - scale * reference->forceSd_N).norm(), 1e-12 * scale);
        const auto length = solve(scale * jacobian, torque_Nm, {0.0005, 0.01 * scale});
        ASSERT_TRUE(length);
        EXPECT_LE((length->force_N - reference->force_N / scale).norm(),
                  1e-11 / scale * reference->force_N.norm());
        EXPECT_NEAR(length->conditionNumber, reference->conditionNumber, 1e-9);
    }
}

TEST(ContactForceStability, turningTheBaseTurnsTheForce) {
    const Arm4Kinematics arm;
    const PointJacobian jacobian = arm.pointJacobian(Link::forearm, {0.1, 0.2, 0.3, 0.01}, {0.17, 0.0, 0.0});
    const JointVector torque_Nm(0.1, -0.2, 0.05, 0.02);
    const auto reference = solve(jacobian, torque_Nm);
    ASSERT_TRUE(reference);
    for (const double angle_rad : {0.1, 1.0, 3.0}) {
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(angle_rad, Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
        const auto turned = solve(turn * jacobian, torque_Nm);
        ASSERT_TRUE(turned);
        EXPECT_LE((turned->force_N - turn * reference->force_N).norm(), 1e-11);
        EXPECT_LE((turned->hidden - turn * reference->hidden * turn.transpose()).norm(), 1e-12);
    }
}

TEST(ContactForceStability, nonFiniteAndHugeNumbersAreRefused) {
    const PointJacobian jacobian = PointJacobian::Ones();
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
        PointJacobian spoiled = jacobian;
        spoiled(1, 2) = bad;
        EXPECT_EQ(solve(spoiled, JointVector::Ones()).error(), ForceRefusal::notFinite);
        EXPECT_EQ(solve(jacobian, {0.0, bad, 0.0, 0.0}).error(), ForceRefusal::notFinite);
        EXPECT_EQ(solve(jacobian, JointVector::Ones(), {bad, 0.01}).error(), ForceRefusal::notFinite);
        EXPECT_EQ(solve(jacobian, JointVector::Ones(), {0.0005, bad}).error(), ForceRefusal::notFinite);
    }
    EXPECT_EQ(solve(1e200 * jacobian, JointVector::Ones()).error(), ForceRefusal::outOfRange);
    EXPECT_EQ(solve(jacobian, 1e200 * JointVector::Ones()).error(), ForceRefusal::outOfRange);
}

TEST(ContactForceStability, zeroJacobianAndZeroTorqueGiveZeroForce) {
    const auto contact = solve(PointJacobian::Zero(), JointVector::Zero());
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->force_N.norm(), 0.0);
    EXPECT_EQ(contact->observedDirections, 0);
}
