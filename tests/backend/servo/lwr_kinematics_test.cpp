// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/lwr_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace teleta::servo;
using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double kPi = std::numbers::pi;

LwrVector joints(double a1, double a2, double a3, double a4, double a5, double a6, double a7) {
    LwrVector q_rad;
    q_rad << a1, a2, a3, a4, a5, a6, a7;
    return q_rad;
}

LwrVector randomJoints(std::mt19937_64& random) {
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    LwrVector q_rad = LwrLimits::highest();
    for (double& angle_rad : q_rad)
        angle_rad *= share(random);
    return q_rad;
}

Isometry3d denavitHartenberg(double theta_rad, double d_m, double alpha_rad) {
    return Isometry3d(AngleAxisd(theta_rad, Vector3d::UnitZ())) * Eigen::Translation3d(0.0, 0.0, d_m) *
           AngleAxisd(alpha_rad, Vector3d::UnitX());
}

void expectNear(const Vector3d& value, const Vector3d& expected, double tolerance = 1e-15) {
    EXPECT_LE((value - expected).cwiseAbs().maxCoeff(), tolerance)
        << value.transpose() << " instead of " << expected.transpose();
}

} // namespace

TEST(LwrKinematics, atZeroTheArmPointsUpAndTheFlangeHasTheAxesOfTheBase) {
    const Isometry3d X = LwrKinematics().X_Base_Tool(LwrVector::Zero());
    expectNear(X.translation(), {0.0, 0.0, 0.310 + 0.400 + 0.390 + 0.078});
    EXPECT_LE((X.linear() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(LwrKinematics, eachJointTurnsAboutItsPublishedAxis) {
    // Axes of the public robot description: z, -y, z, y, z, -y, z.
    const LwrPosture posture = LwrKinematics().forward(LwrVector::Zero());
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();
    const std::array<Vector3d, 7> expected = {z, -y, z, y, z, -y, z};
    const std::array<double, 7> height_m = {0.0, 0.310, 0.310, 0.710, 0.710, 1.100, 1.100};
    for (std::size_t joint = 0; joint < 7; ++joint) {
        expectNear(posture.axis[joint], expected[joint]);
        expectNear(posture.p_Base_Joint[joint], {0.0, 0.0, height_m[joint]});
    }
}

TEST(LwrKinematics, aBentArmIsWhereTheTriangleSays) {
    const LwrKinematics arm;
    // A2 by 90 degrees about -y takes up to -x.
    expectNear(arm.X_Base_Tool(joints(0, kPi / 2.0, 0, 0, 0, 0, 0)).translation(), {-0.868, 0.0, 0.310});
    // A4 by 90 degrees about y takes what is above the elbow to +x.
    expectNear(arm.X_Base_Tool(joints(0, 0, 0, kPi / 2.0, 0, 0, 0)).translation(), {0.468, 0.0, 0.710});
    // A6 by 90 degrees about -y.
    expectNear(arm.X_Base_Tool(joints(0, 0, 0, 0, 0, kPi / 2.0, 0)).translation(), {-0.078, 0.0, 1.100});
    // A1 turns the bent arm to +y.
    expectNear(arm.X_Base_Tool(joints(kPi / 2.0, 0, 0, kPi / 2.0, 0, 0, 0)).translation(),
               {0.0, 0.468, 0.710});
    // A7 turns the flange only.
    const Isometry3d X = arm.X_Base_Tool(joints(0, 0, 0, 0, 0, 0, 0.3));
    expectNear(X.linear().col(0), {std::cos(0.3), std::sin(0.3), 0.0});
}

TEST(LwrKinematics, poseIsTheProductOfTheDenavitHartenbergMatrices) {
    const std::array<double, 7> alpha_deg = {90, -90, -90, 90, 90, -90, 0};
    const std::array<double, 7> d_m = {0.310, 0, 0.400, 0, 0.390, 0, 0.078};
    std::mt19937_64 random(3);
    const Isometry3d X_Flange_Tool =
        Eigen::Translation3d(0.01, -0.02, 0.05) * AngleAxisd(0.4, Vector3d::UnitY());
    const LwrKinematics arm(X_Flange_Tool);
    for (int round = 0; round < 200; ++round) {
        const LwrVector q_rad = randomJoints(random);
        Isometry3d expected = Isometry3d::Identity();
        for (std::size_t joint = 0; joint < 7; ++joint)
            expected = expected * denavitHartenberg(q_rad[static_cast<Eigen::Index>(joint)], d_m[joint],
                                                    alpha_deg[joint] * kPi / 180.0);
        expected = expected * X_Flange_Tool;
        EXPECT_LE((arm.X_Base_Tool(q_rad).matrix() - expected.matrix()).cwiseAbs().maxCoeff(), 2e-15);
        EXPECT_LE((arm.forward(q_rad).X_Base_Tool.matrix() - expected.matrix()).cwiseAbs().maxCoeff(), 2e-15);
    }
}

TEST(LwrKinematics, jacobianIsTheDerivativeOfThePose) {
    std::mt19937_64 random(4);
    const LwrKinematics arm(Isometry3d(Eigen::Translation3d(0.02, 0.01, 0.06)));
    constexpr double kStep_rad = 1e-5;
    for (int round = 0; round < 200; ++round) {
        const LwrVector q_rad = randomJoints(random);
        const LwrPosture posture = arm.forward(q_rad);
        for (int joint = 0; joint < kLwrJoints; ++joint) {
            const LwrVector step_rad = kStep_rad * LwrVector::Unit(joint);
            const Isometry3d ahead = arm.X_Base_Tool(q_rad + step_rad);
            const Isometry3d behind = arm.X_Base_Tool(q_rad - step_rad);
            const Vector3d v = (ahead.translation() - behind.translation()) / (2.0 * kStep_rad);
            const Vector3d w = logSO3(ahead.linear() * behind.linear().transpose()) / (2.0 * kStep_rad);
            expectNear(posture.jacobian.col(joint).head<3>(), v, 1e-9);
            expectNear(posture.jacobian.col(joint).tail<3>(), w, 1e-9);
        }
    }
}
