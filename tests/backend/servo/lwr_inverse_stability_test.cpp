// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/lwr_inverse.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace teleta::servo {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

LwrVector bent(double elbow_rad) {
    LwrVector q_rad;
    q_rad << 0.2, 0.5, -0.35, -elbow_rad, 0.26, 1.0, 0.1;
    return q_rad;
}

Twist wanted() {
    Twist V;
    V << 0.02, -0.01, 0.03, 0.1, -0.05, 0.02;
    return V;
}

/// Of lengths in units of the settings' length.
double sizeOf(const Twist& twist, const InverseSettings& settings) {
    Twist scaled = twist;
    scaled.head<3>() /= settings.length_m;
    return scaled.norm();
}

double conditionOf(LwrJacobian jacobian, const InverseSettings& settings) {
    jacobian.topRows<3>() /= settings.length_m;
    const auto values = jacobian.jacobiSvd().singularValues();
    return values[0] / values[5];
}

} // namespace

TEST(LwrInverseStability, anElbowThatStretchesOverTwelveDecadesNeverAmplifies) {
    const InverseSettings settings;
    for (double elbow_rad = 1.0; elbow_rad > 1e-13; elbow_rad /= 10.0) {
        const LwrPosture posture = LwrKinematics().forward(bent(elbow_rad));
        const JointMotion motion = solveRates(bent(elbow_rad), posture.jacobian, wanted(), settings);
        ASSERT_TRUE(motion.rate_radPerS.array().isFinite().all());
        EXPECT_FALSE(motion.limited()) << elbow_rad;
        EXPECT_LE(sizeOf(motion.achieved, settings), (1.0 + 1e-12) * sizeOf(wanted(), settings)) << elbow_rad;
        if (motion.damping > 0.0) {
            EXPECT_LE(motion.rate_radPerS.norm(),
                      (1.0 + 1e-12) * sizeOf(wanted(), settings) / (2.0 * motion.damping));
        }
    }
}

// J J^T has the square of J's condition number.
TEST(LwrInverseStability, withoutDampingTheErrorGrowsNoFasterThanTheConditionNumberOfWhatIsSolved) {
    InverseSettings settings;
    settings.fadeManipulability = 1e-9;
    settings.limits.fastest_radPerS.setConstant(1e9);
    settings.limits.highest_rad.setConstant(1e9);
    settings.limits.lowest_rad.setConstant(-1e9);
    for (double elbow_rad = 1.0; elbow_rad > 1e-4; elbow_rad /= 2.0) {
        const LwrPosture posture = LwrKinematics().forward(bent(elbow_rad));
        const JointMotion motion = solveRates(bent(elbow_rad), posture.jacobian, wanted(), settings);
        const double condition = conditionOf(posture.jacobian, settings);
        ASSERT_EQ(motion.damping, 0.0);
        // 1e-14 is added to the diagonal, which rounding would make negative.
        EXPECT_LE(sizeOf(motion.achieved - wanted(), settings),
                  (8.0 * kEpsilon + 1e-14) * condition * condition * sizeOf(wanted(), settings))
            << elbow_rad;
    }
}

TEST(LwrInverseStability, smallMotionsScaleOverTwentyFourDecadesAndTurnWithTheirSign) {
    const LwrPosture posture = LwrKinematics().forward(bent(1.4));
    const LwrVector plain = solveRates(bent(1.4), posture.jacobian, wanted()).rate_radPerS;
    for (double factor = 1.0; factor > 1e-25; factor /= 10.0) {
        const LwrVector small = solveRates(bent(1.4), posture.jacobian, factor * wanted()).rate_radPerS;
        EXPECT_LE((small / factor - plain).norm(), 1e-13 * plain.norm()) << factor;
        EXPECT_EQ(solveRates(bent(1.4), posture.jacobian, -factor * wanted()).rate_radPerS, -small);
    }
    EXPECT_EQ(solveRates(bent(1.4), posture.jacobian, Twist::Zero()).rate_radPerS, LwrVector::Zero());
}

TEST(LwrInverseStability, motionsThatNoJointCanMakeKeepTheirDirection) {
    InverseSettings settings;
    settings.brakingTime_s = 1e-15; // no end is near
    const LwrPosture posture = LwrKinematics().forward(bent(1.4));
    for (double factor = 1e2; factor < 1e13; factor *= 10.0) {
        const JointMotion motion = solveRates(bent(1.4), posture.jacobian, factor * wanted(), settings);
        EXPECT_LT(motion.scale, 1.0);
        EXPECT_LE((motion.rate_radPerS.cwiseAbs() - settings.limits.fastest_radPerS).maxCoeff(), 1e-12);
        EXPECT_LE((motion.achieved.normalized() - wanted().normalized()).norm(), 1e-12) << factor;
    }
}

} // namespace teleta::servo
