// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/rigid_motion.h"
#include "backend/servo/tactile_jacobian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace teleta::servo {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Twist twistOf(const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
    Twist xi;
    xi << v, w;
    return xi;
}

class TwistLottery {
public:
    Eigen::Vector3d unit() {
        Eigen::Vector3d vector;
        do
            vector = {m_normal(m_engine), m_normal(m_engine), m_normal(m_engine)};
        while (vector.norm() < 1e-3);
        return vector.normalized();
    }

private:
    std::mt19937_64 m_engine{11};
    std::normal_distribution<double> m_normal;
};

} // namespace

TEST(RigidMotionStability, incrementsKeepTheirDigitsOverTwelveDecadesOfTurnAndTwentyFourOfWay) {
    TwistLottery lottery;
    for (double turn_rad = 1e-12; turn_rad < 2.0; turn_rad *= 10.0)
        for (double way_m = 1e-12; way_m < 2e12; way_m *= 100.0) {
            const Twist xi = twistOf(way_m * lottery.unit(), turn_rad * lottery.unit());
            const Twist back = logSE3(expSE3(xi));
            EXPECT_LE((back.tail<3>() - xi.tail<3>()).norm(), 8.0 * kEpsilon * std::max(turn_rad, 1e-300))
                << turn_rad;
            EXPECT_LE((back.head<3>() - xi.head<3>()).norm(), 16.0 * kEpsilon * way_m) << turn_rad;
        }
}

TEST(RigidMotionStability, aTurnThatApproachesHalfATurnIsKnownToRounding) {
    TwistLottery lottery;
    for (double missing_rad = 1e-12; missing_rad < 2.0; missing_rad *= 10.0)
        for (int trial = 0; trial < 20; ++trial) {
            const Twist xi = twistOf(lottery.unit(), (kPi - missing_rad) * lottery.unit());
            const Twist back = logSE3(expSE3(xi));
            EXPECT_LE((back - xi).norm(), 64.0 * kEpsilon) << missing_rad;
        }
}

TEST(RigidMotionStability, lengthsScaleExactlyWithPowersOfTwo) {
    TwistLottery lottery;
    for (int trial = 0; trial < 50; ++trial) {
        const Eigen::Vector3d v = lottery.unit();
        const Eigen::Vector3d w = 2.0 * lottery.unit();
        const Twist plain = logSE3(expSE3(twistOf(v, w)));
        for (const int exponent : {-40, -7, 13, 40}) {
            const Twist scaled = logSE3(expSE3(twistOf(std::ldexp(1.0, exponent) * v, w)));
            EXPECT_EQ(scaled.head<3>(), std::ldexp(1.0, exponent) * plain.head<3>());
            EXPECT_EQ(scaled.tail<3>(), plain.tail<3>());
        }
    }
}

TEST(RigidMotionStability, turningTheFrameTurnsTheIncrement) {
    TwistLottery lottery;
    for (int trial = 0; trial < 200; ++trial) {
        const Eigen::Isometry3d X(expSE3(twistOf(Eigen::Vector3d::Zero(), 3.0 * lottery.unit())));
        const Twist xi = twistOf(0.3 * lottery.unit(), 2.5 * lottery.unit());
        const Twist turned = logSE3(X * expSE3(xi) * X.inverse(Eigen::Isometry));
        EXPECT_LE((turned - twistTo(X, xi)).norm(), 64.0 * kEpsilon);
    }
}

TEST(RigidMotionStability, aTwistComesBackFromAnotherFrameAtAnyDistance) {
    TwistLottery lottery;
    for (double distance_m = 1e-12; distance_m < 2e12; distance_m *= 10.0) {
        Eigen::Isometry3d X = expSE3(twistOf(Eigen::Vector3d::Zero(), lottery.unit()));
        X.translation() = distance_m * lottery.unit();
        const Twist xi = twistOf(lottery.unit(), lottery.unit());
        const Twist back = twistTo(X.inverse(Eigen::Isometry), twistTo(X, xi));
        EXPECT_LE((back.tail<3>() - xi.tail<3>()).norm(), 8.0 * kEpsilon);
        // The way of a turn seen from afar takes its digits from the velocity.
        EXPECT_LE((back.head<3>() - xi.head<3>()).norm(), 16.0 * kEpsilon * (1.0 + distance_m));
    }
}

TEST(RigidMotionStability, tenMillionIncrementsAreTheirSumAndLeaveARotation) {
    constexpr int kSteps = 10'000'000;
    const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
    const double step_rad = 1.0 / 1024.0;
    const Twist increment = twistOf(Eigen::Vector3d::Zero(), step_rad * axis);
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    for (int i = 0; i < kSteps; ++i)
        X = moved(X, increment);
    EXPECT_LE((X.linear() * X.linear().transpose() - Eigen::Matrix3d::Identity()).norm(), 8.0 * kEpsilon);
    EXPECT_GT(X.linear().determinant(), 0.0);
    const double angle_rad = std::remainder(kSteps * step_rad, 2.0 * kPi);
    EXPECT_LE((logSO3(X.linear()) - angle_rad * axis).norm(), kSteps * kEpsilon);
}

TEST(EdgeDirectionStability, anEdgeThatTurnsForTenMillionFramesIsFollowedModuloPi) {
    constexpr int kFrames = 10'000'000;
    EdgeDirection edge;
    double worst = 0.0;
    double farthest_rad = 0.0;
    for (int i = 0; i < kFrames; ++i) {
        // From -90 to 90 degrees and again, as the features tell it.
        const double alpha_rad = kPi * (static_cast<double>(i % 1000) / 1000.0 - 0.499);
        const double followed_rad = edge.follow(alpha_rad, 0.3);
        worst = std::max(worst, std::abs(std::remainder(followed_rad - alpha_rad, kPi)));
        farthest_rad = std::max(farthest_rad, std::abs(0.3 - followed_rad));
    }
    EXPECT_LE(worst, 8.0 * kEpsilon);
    EXPECT_LE(farthest_rad, kPi / 2.0 + EdgeDirection::kMargin_rad + 1e-12);
}

} // namespace teleta::servo
