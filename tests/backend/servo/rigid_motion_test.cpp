// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/servo/servo_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace teleta::servo;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using teleta::servo::test::adjoint;
using teleta::servo::test::wrenchTo;

namespace {

constexpr double kPi = std::numbers::pi;

class Motions {
public:
    Vector3d direction() {
        Vector3d vector;
        do
            vector = Vector3d(m_one(m_random), m_one(m_random), m_one(m_random));
        while (vector.norm() < 0.1 || vector.norm() > 1.0);
        return vector.normalized();
    }
    Twist twist(double angle_rad) {
        Twist xi;
        xi << direction() * 0.7, direction() * angle_rad;
        return xi;
    }
    Isometry3d pose() { return expSE3(twist(3.0 * m_one(m_random))); }

private:
    std::mt19937_64 m_random{11};
    std::uniform_real_distribution<double> m_one{-1.0, 1.0};
};

Eigen::Matrix4d generator(const Twist& xi) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    matrix.topLeftCorner<3, 3>() = skew(xi.tail<3>());
    matrix.topRightCorner<3, 1>() = xi.head<3>();
    return matrix;
}

/// Series of the matrix exponential, scaled and squared.
Eigen::Matrix4d exponential(const Eigen::Matrix4d& matrix) {
    constexpr int kSquarings = 5;
    const Eigen::Matrix4d small = matrix / (1 << kSquarings);
    Eigen::Matrix4d term = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d sum = term;
    for (int order = 1; order < 25; ++order) {
        term = term * small / order;
        sum += term;
    }
    for (int square = 0; square < kSquarings; ++square)
        sum = sum * sum;
    return sum;
}

double distance(const Isometry3d& a, const Isometry3d& b) {
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

} // namespace

TEST(RigidMotion, exponentialIsThatOfTheMatrix) {
    Motions motions;
    for (const double angle_rad : {1e-9, 1e-4, 0.1, 0.2499, 0.2501, 1.0, 2.0, kPi - 1e-6, kPi, 6.0})
        for (int round = 0; round < 20; ++round) {
            const Twist xi = motions.twist(angle_rad);
            const Eigen::Matrix4d expected = exponential(generator(xi));
            EXPECT_LE((expSE3(xi).matrix() - expected).cwiseAbs().maxCoeff(), 2e-14) << angle_rad;
        }
}

TEST(RigidMotion, aScrewOfAQuarterTurnMovesAlongItsAxisAndAroundIt) {
    // About the vertical axis through (1, 0, 0), rising 0.2 m: v = -w x q + 0.2 z.
    Twist xi;
    xi << 0.0, -kPi / 2.0, 0.2, 0.0, 0.0, kPi / 2.0;
    const Isometry3d X = expSE3(xi);
    EXPECT_LE((X * Vector3d::Zero() - Vector3d(1.0, -1.0, 0.2)).norm(), 1e-15);
    EXPECT_LE((X * Vector3d(2.0, 0.0, 0.0) - Vector3d(1.0, 1.0, 0.2)).norm(), 1e-15);
}

TEST(RigidMotion, translationOnlyKeepsEveryDigit) {
    Twist xi;
    xi << 0.1, -0.2, 0.3, 0.0, 0.0, 0.0;
    EXPECT_EQ(Vector3d(expSE3(xi).translation()), Vector3d(0.1, -0.2, 0.3));
    EXPECT_EQ(logSE3(expSE3(xi)), xi);
}

TEST(RigidMotion, logarithmUndoesTheExponential) {
    Motions motions;
    for (const double angle_rad : {0.0, 1e-300, 1e-16, 1e-12, 1e-8, 1e-4, 0.2499, 0.2501, 1.0, 2.0, 3.0,
                                   kPi - 1e-4, kPi - 1e-8, kPi - 1e-13})
        for (int round = 0; round < 50; ++round) {
            const Twist xi = motions.twist(angle_rad);
            EXPECT_LE((logSE3(expSE3(xi)) - xi).cwiseAbs().maxCoeff(), 1e-14) << angle_rad;
        }
}

TEST(RigidMotion, smallRotationsKeepTheirRelativePrecision) {
    Twist xi;
    xi << 0.0, 0.0, 0.0, 3e-9, -2e-9, 1e-9;
    EXPECT_LE((logSE3(expSE3(xi)) - xi).norm(), 1e-15 * xi.norm());
}

TEST(RigidMotion, atAHalfTurnTheFirstComponentOfTheAxisIsPositive) {
    for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1),
                                 Vector3d(0.6, -0.8, 0), Vector3d(0, 0.6, -0.8)}) {
        Twist xi;
        xi << 0.3, -0.1, 0.2, kPi * axis;
        EXPECT_LE((logSE3(expSE3(xi)) - xi).norm(), 1e-14) << axis.transpose();
        Twist opposite = xi;
        opposite.tail<3>() = -xi.tail<3>();
        const Twist back = logSE3(expSE3(opposite));
        EXPECT_LE((back.tail<3>() - kPi * axis).norm(), 1e-14) << axis.transpose();
        EXPECT_LE(distance(expSE3(back), expSE3(opposite)), 1e-14);
    }
}

TEST(RigidMotion, adjointCarriesATwistToAnotherFrame) {
    Motions motions;
    for (int round = 0; round < 50; ++round) {
        const Isometry3d X = motions.pose();
        const Twist xi = motions.twist(0.8);
        const Twist moved_A = twistTo(X, xi);
        EXPECT_LE((adjoint(X) * xi - moved_A).norm(), 1e-15);
        const Eigen::Matrix4d expected = X.matrix() * generator(xi) * X.inverse().matrix();
        EXPECT_LE((generator(moved_A) - expected).cwiseAbs().maxCoeff(), 1e-15);
    }
}

TEST(RigidMotion, powerIsTheSameInEveryFrame) {
    Motions motions;
    for (int round = 0; round < 50; ++round) {
        const Isometry3d X = motions.pose();
        const Twist twist = motions.twist(1.0);
        const Wrench wrench = motions.twist(2.0);
        EXPECT_NEAR(twistTo(X, twist).dot(wrenchTo(X, wrench)), twist.dot(wrench), 1e-14);
    }
}

TEST(RigidMotion, anIncrementInTheBaseIsTheOneInTheSensorByTheAdjoint) {
    Motions motions;
    for (int round = 0; round < 50; ++round) {
        const Isometry3d X = motions.pose();
        const Twist increment_Sensor = motions.twist(0.3);
        EXPECT_LE(distance(moved(X, adjoint(X) * increment_Sensor), X * expSE3(increment_Sensor)), 1e-15 * 4);
        EXPECT_LE((poseDifference(X, X * expSE3(increment_Sensor)) - increment_Sensor).norm(), 1e-15 * 8);
    }
}

TEST(RigidMotion, rotationsAboutDifferentAxesDoNotAddUpAsEulerAngles) {
    // 90 degrees about x, then 90 about the sensor's own y: closed form, R = Rx(90) Ry(90).
    Twist aboutX = Twist::Zero();
    aboutX[3] = kPi / 2.0;
    Twist aboutY = Twist::Zero();
    aboutY[4] = kPi / 2.0;
    Isometry3d X = moved(Isometry3d::Identity(), aboutX);
    X = moved(X, twistTo(X, aboutY));
    Eigen::Matrix3d expected;
    expected << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    EXPECT_LE((X.linear() - expected).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(RigidMotion, aMillionIncrementsLeaveARotation) {
    Twist increment;
    increment << 1e-6, -2e-6, 1e-6, 1e-3, 2e-3, -1e-3;
    Isometry3d X = Isometry3d::Identity();
    for (int step = 0; step < 1'000'000; ++step)
        X = moved(X, twistTo(X, increment));
    EXPECT_LE((X.linear().transpose() * X.linear() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(),
              1e-15);
    // The closed form of a million equal steps is one of a million times the twist. Each step rounds the
    // angle by at most an epsilon.
    const Isometry3d expected = expSE3(1e6 * increment);
    EXPECT_LE(distance(X, expected), 1e-9);
}
