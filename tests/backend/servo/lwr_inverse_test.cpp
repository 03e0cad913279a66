// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/lwr_inverse.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace teleta::servo;
using Eigen::Isometry3d;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

LwrVector degrees(double a1, double a2, double a3, double a4, double a5, double a6, double a7) {
    LwrVector q;
    q << a1, a2, a3, a4, a5, a6, a7;
    return kDegree * q;
}

const LwrVector kBent_rad = degrees(10, 30, -20, -80, 15, 60, 5);

Twist twist(double vx, double vy, double vz, double wx, double wy, double wz) {
    Twist V;
    V << vx, vy, vz, wx, wy, wz;
    return V;
}

} // namespace

TEST(LwrInverse, awayFromSingularitiesTheToolMovesAsWantedWithTheLeastRates) {
    const LwrPosture posture = LwrKinematics().forward(kBent_rad);
    const Twist wanted = twist(0.02, -0.01, 0.03, 0.1, -0.05, 0.02);
    const JointMotion motion = solveRates(kBent_rad, posture.jacobian, wanted);
    EXPECT_EQ(motion.damping, 0.0);
    EXPECT_FALSE(motion.limited());
    EXPECT_LE((motion.achieved - wanted).norm(), 1e-12);
    const LwrVector least =
        posture.jacobian.jacobiSvd(Eigen::ComputeFullU | Eigen::ComputeFullV).solve(wanted);
    EXPECT_LE((motion.rate_radPerS - least).norm(), 1e-11);
}

TEST(LwrInverse, manipulabilityIsTheProductOfTheSingularValues) {
    LwrJacobian J = LwrKinematics().forward(kBent_rad).jacobian;
    const double w = solveRates(kBent_rad, J, Twist::Zero()).manipulability;
    J.topRows<3>() /= InverseSettings{}.length_m;
    EXPECT_NEAR(w, J.jacobiSvd().singularValues().prod(), 1e-12);
}

TEST(LwrInverse, nearASingularityRatesStayBoundedAndTheRestOfTheMotionIsKept) {
    // Stretched arm: it cannot move along itself.
    const LwrVector q_rad = degrees(0, 40, 0, 0, 0, 0, 0);
    const LwrPosture posture = LwrKinematics().forward(q_rad);
    const Eigen::Vector3d along = posture.X_Base_Tool.linear().col(2);
    Twist wanted = Twist::Zero();
    wanted.head<3>() = 0.05 * along;
    const JointMotion motion = solveRates(q_rad, posture.jacobian, wanted);
    EXPECT_LT(motion.manipulability, 1e-12);
    EXPECT_DOUBLE_EQ(motion.damping, InverseSettings{}.highestDamping);
    // Gain of the damped inverse is at most 1/(2 lambda), in units of the characteristic length.
    const InverseSettings settings;
    EXPECT_LE(motion.rate_radPerS.norm(), 0.05 / settings.length_m / (2.0 * settings.highestDamping));
    EXPECT_NEAR(motion.achieved.head<3>().dot(along), 0.0, 1e-9);
}

TEST(LwrInverse, ratesHaveNoJumpOnTheWayThroughASingularity) {
    const LwrKinematics arm;
    const Twist wanted = twist(0.02, 0.0, 0.02, 0.0, 0.02, 0.0);
    InverseSettings settings;
    LwrVector before = LwrVector::Zero();
    double largestRate = 0.0;
    double largestJump = 0.0;
    constexpr int kSteps = 4000;
    for (int step = 0; step <= kSteps; ++step) {
        LwrVector q_rad = degrees(5, 40, 10, 0, -10, 35, 0);
        q_rad[3] = 0.8 * (step - kSteps / 2) / (kSteps / 2.0);
        const JointMotion motion = solveRates(q_rad, arm.forward(q_rad).jacobian, wanted, settings);
        ASSERT_TRUE(motion.rate_radPerS.array().isFinite().all());
        LwrJacobian J = arm.forward(q_rad).jacobian;
        J.topRows<3>() /= settings.length_m;
        const Eigen::ArrayXd sigma = J.jacobiSvd().singularValues();
        const double gain = (sigma / (sigma.square() + motion.damping * motion.damping)).maxCoeff();
        Twist scaled = wanted;
        scaled.head<3>() /= settings.length_m;
        EXPECT_LE(motion.rate_radPerS.norm(), gain * scaled.norm() * (1.0 + 1e-6));
        largestRate = std::max(largestRate, motion.rate_radPerS.norm());
        if (step > 0)
            largestJump = std::max(largestJump, (motion.rate_radPerS - before).norm());
        before = motion.rate_radPerS;
    }
    // A step turns A4 by 0.02 degrees.
    EXPECT_LE(largestJump, 0.02 * largestRate);
}

TEST(LwrInverse, aJointAtItsEndStaysAndTheOthersTakeOver) {
    LwrVector q_rad = kBent_rad;
    const LwrLimits limits;
    q_rad[3] = limits.lowest_rad[3];
    const LwrPosture posture = LwrKinematics().forward(q_rad);
    // The motion for which A4 alone would turn further down.
    const Twist wanted = -0.1 * posture.jacobian.col(3);
    const JointMotion motion = solveRates(q_rad, posture.jacobian, wanted);
    EXPECT_TRUE(motion.atEnd[3]);
    EXPECT_TRUE(motion.limited());
    EXPECT_EQ(motion.rate_radPerS[3], 0.0);
    // Six joints are left, which can still do it, unless the inverse is damped.
    EXPECT_LE((motion.achieved - wanted).norm(), motion.damping == 0.0 ? 1e-9 : wanted.norm());
    // The way back is free.
    const JointMotion back = solveRates(q_rad, posture.jacobian, -wanted);
    EXPECT_GT(back.rate_radPerS[3], 0.0);
    EXPECT_FALSE(back.atEnd[3]);
}

TEST(LwrInverse, nearItsEndAJointSlowsDown) {
    LwrVector q_rad = kBent_rad;
    const InverseSettings settings;
    q_rad[3] = settings.limits.lowest_rad[3] + 0.001;
    const LwrPosture posture = LwrKinematics().forward(q_rad);
    const JointMotion motion = solveRates(q_rad, posture.jacobian, -0.5 * posture.jacobian.col(3), settings);
    EXPECT_NEAR(motion.rate_radPerS[3], -0.001 / settings.brakingTime_s, 1e-12);
}

TEST(LwrInverse, aJointOutsideOfItsRangeMayOnlyReturn) {
    LwrVector q_rad = kBent_rad;
    q_rad[3] = LwrLimits{}.lowest_rad[3] - 0.05;
    const LwrPosture posture = LwrKinematics().forward(q_rad);
    EXPECT_EQ(solveRates(q_rad, posture.jacobian, -0.1 * posture.jacobian.col(3)).rate_radPerS[3], 0.0);
    EXPECT_GT(solveRates(q_rad, posture.jacobian, 0.1 * posture.jacobian.col(3)).rate_radPerS[3], 0.0);
}

TEST(LwrInverse, speedLimitsLowerAllRatesTogether) {
    const LwrPosture posture = LwrKinematics().forward(kBent_rad);
    const Twist wanted = twist(1.0, -0.4, 0.6, 0.4, 0.0, 0.0);
    const JointMotion motion = solveRates(kBent_rad, posture.jacobian, wanted);
    ASSERT_LT(motion.scale, 1.0);
    ASSERT_TRUE(motion.atEnd.none());
    EXPECT_LE((motion.achieved - motion.scale * wanted).norm(), 1e-12);
    EXPECT_NEAR(motion.rate_radPerS.cwiseAbs().cwiseQuotient(LwrLimits{}.fastest_radPerS).maxCoeff(), 1.0,
                1e-15);
}

TEST(LwrInverse, theRestPostureIsApproachedWithoutMovingTheTool) {
    const LwrKinematics arm;
    InverseSettings settings;
    settings.restGain_perS = 0.5;
    settings.rest_rad = degrees(0, 40, 0, -90, 0, 40, 0);
    LwrVector q_rad = kBent_rad;
    const Isometry3d start = arm.X_Base_Tool(q_rad);
    const double before = (q_rad - settings.rest_rad).norm();
    for (int step = 0; step < 4000; ++step) {
        const LwrPosture posture = arm.forward(q_rad);
        const JointMotion motion = solveRates(q_rad, posture.jacobian, Twist::Zero(), settings);
        EXPECT_LE(motion.achieved.norm(), 1e-12);
        q_rad += 1e-3 * motion.rate_radPerS;
    }
    EXPECT_LT((q_rad - settings.rest_rad).norm(), 0.99 * before);
    EXPECT_LE(poseDifference(start, arm.X_Base_Tool(q_rad)).norm(), 1e-4);
}

TEST(LwrInverse, whatIsNotFiniteGivesNoMotion) {
    const LwrPosture posture = LwrKinematics().forward(kBent_rad);
    Twist wanted = Twist::Zero();
    wanted[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(solveRates(kBent_rad, posture.jacobian, wanted).rate_radPerS, LwrVector(LwrVector::Zero()));
    LwrVector q_rad = kBent_rad;
    q_rad[0] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(solveRates(q_rad, posture.jacobian, Twist::Zero()).rate_radPerS, LwrVector(LwrVector::Zero()));
}
